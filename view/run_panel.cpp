#include "view/run_panel.h"

#include "report/run/run_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::view {

namespace {

namespace fs = std::filesystem;

OrderedJson headOf(const ObservedRun& run) {
  auto head = report::runHeadJson({run.program, run.executable});
  const auto& main = run.executable.model.mainSkill;
  head["description"] = "a run of " + (main.empty() ? "a library of skills" : "`" + main + "`");
  return head;
}

OrderedJson orNull(const std::string& text) {
  return text.empty() ? OrderedJson() : OrderedJson(text);
}

std::string clockOf(std::optional<double> speed) {
  if (!speed) return "simulated time";
  return *speed == 1 ? "real time" : fmt::format("{} times real time", *speed);
}

double seconds(runtime::Nanoseconds time) {
  return static_cast<double>(time) / static_cast<double>(runtime::kSecond);
}

} // namespace

RunPanel::RunPanel(ObservedRun of, EventFeed& news)
    : observed(std::move(of)),
      feed(news, headOf(observed), observed.waits && !observed.speed, [this] { return status(); }) {
}

void RunPanel::finish(const runtime::RunResult& ended) {
  {
    const std::lock_guard lock(mutex);
    result = {{"why", report::toWords(ended.end)},
              {"mission", ended.missionStatus},
              {"bad", ended.bad},
              {"date", seconds(ended.date)},
              {"properties",
               report::runPropertiesJson({observed.program, observed.executable}, ended.verdicts)}};
    if (!ended.failure.empty()) result["failure"] = ended.failure;
  }
  feed.finish();
}

bool RunPanel::takesSignals() const {
  for (std::size_t i = 0; i < observed.executable.model.signals.size(); ++i)
    if (whyNotSent(i).empty()) return true;
  return false;
}

OrderedJson RunPanel::program() {
  const auto& path = observed.program.files.front().path;
  const auto& main = observed.executable.model.mainSkill;
  const auto head = headOf(observed);
  const std::lock_guard lock(mutex);
  const bool good = result.is_null() || result["bad"] == 0;
  OrderedJson property{{"name", head["name"]},
                       {"kind", "trace"},
                       {"subject", ""},
                       {"description", head["description"]},
                       {"verdict", head["verdict"]},
                       {"good", good},
                       {"severity", "error"},
                       {"location", nullptr},
                       {"trace", nullptr},
                       {"steps", feed.total()}};
  return {{"version", 1},
          {"program", path.generic_string()},
          {"main", orNull(main)},
          {"properties", OrderedJson::array({std::move(property)})},
          {"exploration", nullptr},
          {"label", path.filename().generic_string()},
          {"state", "done"},
          {"stale", false},
          {"message", ""},
          {"progress", nullptr},
          {"pictures", picturesJson(observed.program)},
          {"files", filesJson(observed.program)}};
}

PanelData::Answer RunPanel::trace(const std::string& name) {
  if (name != "run") return std::unexpected("this property has no trace");
  return feed.trace();
}

PanelData::Answer RunPanel::picture(const PictureParams& params) {
  return pictureJson(observed.program, params, false);
}

PanelData::Answer RunPanel::source(const std::string& uri) {
  return sourceJson(observed.program, uri);
}

PanelData::Answer RunPanel::simulate(const OrderedJson&) {
  return std::unexpected("this is a run: `proskill view` simulates");
}

OrderedJson RunPanel::run() {
  auto head = headOf(observed);
  head["steps"] = OrderedJson::array();
  return {{"trace", std::move(head)},
          {"processes", report::runPlacesJson({observed.program, observed.executable})},
          {"clock", clockOf(observed.speed)},
          {"whyNoControl", orNull(observed.whyNoControl)},
          {"whyNoPause", orNull(observed.whyNoPause)},
          {"properties", report::runPropertiesJson({observed.program, observed.executable}, {})},
          {"signals", signals()},
          {"status", status()}};
}

OrderedJson RunPanel::signals() const {
  const auto& all = observed.executable.model.signals;
  OrderedJson list = OrderedJson::array();
  for (std::size_t i = 0; i < all.size(); ++i)
    list.push_back({{"name", all[i].name},
                    {"interrupts", all[i].interrupts},
                    {"whyNot", orNull(whyNotSent(i))}});
  return list;
}

/// Why a run never takes this signal.
std::string RunPanel::whyNotSent(std::size_t signal) const {
  const auto port = observed.executable.signalPorts[signal];
  if (port != verify::kNone && !observed.executable.atPort[port].empty()) return "";
  return observed.executable.model.hasEnvironment
             ? "the program's environment causes it, unless a platform file has `events`"
             : "nothing in the program takes it";
}

OrderedJson RunPanel::status() const {
  const std::lock_guard lock(mutex);
  const auto speed = result.is_null() && !observed.pause.isHeld() ? observed.speed.value_or(0) : 0;
  const auto date = result.is_null() ? seconds(observed.pause.date(observed.speed.value_or(0)))
                                     : result["date"].get<double>();
  return {{"state", stateOf()},
          {"steps", feed.total()},
          {"date", date},
          {"speed", speed},
          {"waiting", observed.inbox.waiting()},
          {"lost", feed.lost()},
          {"end", result}};
}

std::string RunPanel::stateOf() const {
  if (!result.is_null()) return "ended";
  return observed.pause.isHeld() ? "paused" : "running";
}

PanelData::Answer RunPanel::steps(const OrderedJson& params) {
  return feed.from(params.value("from", std::size_t{0}));
}

PanelData::Answer RunPanel::control(const OrderedJson& params) {
  auto refusal = obey(params.value("do", std::string()), params.value("signal", std::string()));
  if (!refusal.empty()) return std::unexpected(std::move(refusal));
  feed.wake();
  return status();
}

std::string RunPanel::obey(const std::string& action, const std::string& signal) {
  const std::lock_guard lock(controls);
  if (isOver()) return action == "close" ? close() : "the run has ended";
  if (action == "close") return "the run has not ended";
  if (!observed.whyNoControl.empty()) return observed.whyNoControl;
  if (action == "send") return send(signal);
  if (action == "end") return end();
  return pauseOr(action);
}

bool RunPanel::isOver() const {
  const std::lock_guard lock(mutex);
  return !result.is_null();
}

std::string RunPanel::pauseOr(const std::string& action) {
  auto& pause = observed.pause;
  if (action != "pause" && action != "continue" && action != "step")
    return "there is no such control";
  if (!observed.whyNoPause.empty()) return observed.whyNoPause;
  if (action == "continue") pause.resume();
  if (action == "pause") pause.hold();
  if (action != "step") return "";
  if (!pause.isHeld()) return "only a paused run takes single steps";
  pause.step();
  return "";
}

std::string RunPanel::send(const std::string& name) {
  const auto& all = observed.executable.model.signals;
  const auto found = std::ranges::find(all, name, &codegen::Signal::name);
  if (found == all.end())
    return "there is neither an event nor an interruptible skill of this name";
  const auto index = static_cast<std::uint32_t>(found - all.begin());
  if (auto why = whyNotSent(index); !why.empty()) return why;
  return observed.inbox.send(index) ? "" : "too much waits to be taken by the run";
}

std::string RunPanel::close() { return observed.whyNoClose.empty() ? end() : observed.whyNoClose; }

std::string RunPanel::end() {
  observed.askToEnd();
  return "";
}

} // namespace proskill::view
