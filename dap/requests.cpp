#include "dap/adapter.h"

#include "ide/description/markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

/// Requests that start a session, set breakpoints and move through the steps.
namespace proskill::dap {

namespace {

std::string wordsOf(const worker::WorkerProgress& now) {
  return fmt::format("{} of {} decided, {} states, {:.0f} a second", now.decided, now.total,
                     now.classes, now.rate());
}

const Json& listIn(const Json& arguments, const char* name) {
  static const Json nothing = Json::array();
  auto found = arguments.find(name);
  return found != arguments.end() && found->is_array() ? *found : nothing;
}

} // namespace

Adapter::Answer Adapter::initialize(const Json& arguments) {
  const auto flag = [&](const char* name, bool otherwise) {
    const auto value = arguments.value(name, Json());
    return value.is_boolean() ? value.get<bool>() : otherwise;
  };
  linesFromOne = flag("linesStartAt1", true);
  columnsFromOne = flag("columnsStartAt1", true);
  showsProgress = flag("supportsProgressReporting", false);
  return Json{
      {"supportsConfigurationDoneRequest", true}, {"supportsStepBack", true},
      {"supportsStepInTargetsRequest", true},     {"supportsDataBreakpoints", true},
      {"supportsEvaluateForHovers", true},        {"supportsRestartRequest", true},
      {"supportsTerminateRequest", true},         {"supportsDelayedStackTraceLoading", true}};
}

Adapter::Answer Adapter::launch(const Json& arguments) {
  if (player) return std::unexpected("a session is already running");
  auto read = readLaunch(arguments);
  if (!read) return std::unexpected(read.error());
  launched = std::move(*read);
  const bool verifies = launched.trace.empty() && !launched.simulate;
  const auto what = "Verifying " + launched.program.filename().string();
  if (verifies && showsProgress)
    event("progressStart", {{"progressId", "verify"}, {"title", what}, {"cancellable", false}});
  auto source = openSource(
      launched, {disk, options.worker, cancellation,
                 [&](const auto& now) {
                   if (!showsProgress) return console(wordsOf(now));
                   event("progressUpdate", {{"progressId", "verify"}, {"message", wordsOf(now)}});
                 },
                 [this](const std::string& text) { console(text); }});
  if (verifies && showsProgress) event("progressEnd", {{"progressId", "verify"}});
  if (!source) return std::unexpected(source.error());
  player = std::make_unique<Player>(std::move(*source));
  const auto& trace = player->trace();
  if (!trace.description.empty())
    console(fmt::format("{}: {}", ide::withoutBackticks(trace.description), trace.verdict));
  if (!trace.summary.empty()) console(ide::withoutBackticks(trace.summary));
  return Json();
}

Adapter::Answer Adapter::configurationDone(const Json&) {
  configured = true;
  return Json();
}

Adapter::Answer Adapter::disconnect(const Json&) {
  finished = true;
  return Json();
}

/// Answers requests that need no action.
Adapter::Answer Adapter::setNothing(const Json&) { return Json(); }

Adapter::Answer Adapter::setBreakpoints(const Json& arguments) {
  const auto path = oneSpelling(arguments.at("source").at("path").get<std::string>());
  std::set<unsigned> lines;
  Json all = Json::array();
  for (const auto& asked : listIn(arguments, "breakpoints")) {
    const auto given = asked.at("line").get<unsigned>();
    const unsigned fromOne = given + (linesFromOne ? 0 : 1);
    const bool found = player->hasLine(path, fromOne);
    Json breakpoint{{"verified", found}, {"line", given}};
    if (found)
      lines.insert(fromOne);
    else
      breakpoint["message"] = player->isSimulation() ? "nothing happens at this line"
                                                     : "no step of the trace is at this line";
    all.push_back(std::move(breakpoint));
  }
  player->setBreakpoints(path, std::move(lines));
  return Json{{"breakpoints", all}};
}

Adapter::Answer Adapter::dataBreakpointInfo(const Json& arguments) {
  const auto name = arguments.at("name").get<std::string>();
  const auto values = player->valuesAt(0);
  if (std::ranges::find(values, name, [](const auto& it) { return it.first; }) == values.end())
    return Json{{"dataId", nullptr}, {"description", "not a variable of the program"}};
  return Json{{"dataId", name},
              {"description", fmt::format("when `{}` changes", name)},
              {"accessTypes", Json::array({"write"})}};
}

Adapter::Answer Adapter::setDataBreakpoints(const Json& arguments) {
  std::set<std::string> names;
  Json all = Json::array();
  for (const auto& asked : listIn(arguments, "breakpoints")) {
    names.insert(asked.at("dataId").get<std::string>());
    all.push_back({{"verified", true}});
  }
  player->setWatched(std::move(names));
  return Json{{"breakpoints", all}};
}

Adapter::Answer Adapter::next(const Json&) {
  stop = player->step();
  return Json();
}

Adapter::Answer Adapter::stepIn(const Json& arguments) {
  const auto target = arguments.value("targetId", Json());
  if (target.is_null()) return next(arguments);
  return choose({{"id", target}});
}

Adapter::Answer Adapter::stepOut(const Json& arguments) {
  const auto* actor = actorOf(arguments);
  stop = player->runUntil(actor ? *actor : player->actor());
  return Json();
}

Adapter::Answer Adapter::stepBack(const Json&) {
  stop = player->stepBack();
  return Json();
}

Adapter::Answer Adapter::resume(const Json&) {
  stop = player->run();
  if (*stop == Stop::TooLong) stopWords = "Paused: the simulation may be endless";
  return Json{{"allThreadsContinued", true}};
}

Adapter::Answer Adapter::reverseContinue(const Json&) {
  stop = player->runBack();
  return Json();
}

/// Nothing runs between two requests, so there is nothing to pause.
Adapter::Answer Adapter::pause(const Json&) {
  stop = Stop::Step;
  return Json();
}

Adapter::Answer Adapter::restart(const Json&) {
  player->goTo(0);
  stop = Stop::Start;
  return Json();
}

Json Adapter::choiceJson(std::size_t i) const {
  const auto& step = player->choices()[i];
  Json json{{"id", i + 1},
            {"label", fmt::format("{} {} {}", step.actor, ide::withoutBackticks(step.description),
                                  windowOf(step))},
            {"actor", step.actor},
            {"description", step.description},
            {"date", step.date},
            {"earliest", step.earliest},
            {"latest", step.latest ? Json(*step.latest) : Json()},
            {"window", windowOf(step)}};
  if (step.place) json.update(frame(0, "", step.place));
  json.erase("name");
  json["id"] = i + 1;
  return json;
}

Adapter::Answer Adapter::stepInTargets(const Json&) {
  Json targets = Json::array();
  for (std::size_t i = 0; player->isSimulation() && i < player->choices().size(); ++i)
    targets.push_back(choiceJson(i));
  return Json{{"targets", targets}};
}

Adapter::Answer Adapter::choices(const Json&) {
  Json all = Json::array();
  for (std::size_t i = 0; i < player->choices().size(); ++i) all.push_back(choiceJson(i));
  return Json{{"choices", all}, {"simulation", player->isSimulation()}};
}

Adapter::Answer Adapter::choose(const Json& arguments) {
  const auto id = arguments.at("id").get<std::size_t>();
  if (id < 1 || id > player->choices().size())
    return std::unexpected(fmt::format("there is no choice {}", id));
  stop = player->step(id - 1);
  return Json();
}

Adapter::Answer Adapter::position(const Json&) {
  const auto& trace = player->trace();
  return Json{{"position", player->position()},
              {"total", player->isSimulation() ? Json() : Json(trace.steps.size())},
              {"simulation", player->isSimulation()},
              {"name", trace.name},
              {"description", trace.description},
              {"verdict", trace.verdict}};
}

Adapter::Answer Adapter::goTo(const Json& arguments) {
  player->goTo(arguments.at("position").get<std::size_t>());
  stop = player->position() == 0 ? Stop::Start : Stop::Step;
  return Json();
}

} // namespace proskill::dap
