#include "dap/adapter.h"

#include "ide/description/markup.h"

#include <fmt/format.h>

#include <algorithm>

/// Requests about the current stop: threads, stacks, variables.
namespace proskill::dap {

namespace {

/// Identifies a frame: its actor, the number of steps taken, and whether it shows the last of these
/// or the next one.
struct FrameKey {
  long long thread = 0;
  std::size_t position = 0;
  bool isPast = false;

  static constexpr long long kPositions = 1LL << 24;

  [[nodiscard]] long long id() const {
    return (thread * 2 + (isPast ? 1 : 0)) * kPositions + static_cast<long long>(position) + 1;
  }
  static FrameKey of(long long id) {
    const auto rest = (id - 1) / kPositions;
    return {rest / 2, static_cast<std::size_t>((id - 1) % kPositions), rest % 2 == 1};
  }
};

enum class Scope : std::uint8_t { StateVariables, Skills, Time };
constexpr long long kScopes = 3;

/// The number of a scope of a frame, from 1.
long long referenceOf(const FrameKey& frame, Scope scope) {
  const auto moment = static_cast<long long>(frame.position) * 2 + (frame.isPast ? 1 : 0);
  return moment * kScopes + static_cast<long long>(scope) + 1;
}

Json variable(std::string_view name, std::string_view value, const std::string& type = {}) {
  Json json{{"name", name}, {"value", value}, {"variablesReference", 0}};
  if (!type.empty()) json["type"] = type;
  return json;
}

bool isStatus(std::string_view name) { return name.ends_with(".status"); }

/// A step as a line of the call stack.
std::string lineOf(const Step& step, std::string_view tense) {
  return fmt::format("{} s: {}{}", step.date, tense,
                     step.description.empty() ? "a step" : ide::withoutBackticks(step.description));
}

} // namespace

long long Adapter::threadOf(const std::string& actor) const {
  const auto& actors = player->actors();
  auto found = std::ranges::find(actors, actor);
  return found == actors.end() ? 1 : found - actors.begin() + 1;
}

const std::string* Adapter::actorOf(const Json& arguments) const {
  const auto id = arguments.value("threadId", Json());
  const auto& actors = player->actors();
  if (!id.is_number_integer() || id.get<long long>() < 1 ||
      id.get<long long>() > static_cast<long long>(actors.size()))
    return nullptr;
  return &actors[static_cast<std::size_t>(id.get<long long>() - 1)];
}

Adapter::Answer Adapter::threads(const Json&) {
  Json all = Json::array();
  const auto& actors = player->actors();
  for (std::size_t i = 0; i < actors.size(); ++i)
    all.push_back({{"id", i + 1}, {"name", actors[i].empty() ? "the program" : actors[i]}});
  if (all.empty()) all.push_back({{"id", 1}, {"name", "the program"}});
  return Json{{"threads", all}};
}

Json Adapter::frame(long long id, const std::string& name,
                    const std::optional<Place>& place) const {
  Json json{{"id", id}, {"name", name}, {"line", 0}, {"column", 0}};
  if (!place) {
    json["presentationHint"] = "label";
    return json;
  }
  json["source"] = {{"name", place->path.filename().string()}, {"path", place->path.string()}};
  json["line"] = line(place->line);
  json["column"] = column(place->column);
  json["endLine"] = line(place->endLine);
  json["endColumn"] = column(place->endColumn);
  return json;
}

/// The actor's next step, and below it its past steps, the latest first.
Adapter::Answer Adapter::stackTrace(const Json& arguments) {
  const auto* actor = actorOf(arguments);
  if (!actor) {
    if (player->actors().empty()) return Json{{"stackFrames", Json::array()}, {"totalFrames", 0}};
    return std::unexpected("there is no such thread");
  }
  const auto thread = threadOf(*actor);
  Json frames = Json::array();
  const auto& next = player->choices();
  if (!next.empty() && next.front().actor == *actor)
    frames.push_back(frame(FrameKey{thread, player->position(), false}.id(),
                           lineOf(next.front(), "next: "), next.front().place));
  for (std::size_t i = player->position(); i-- > 0;)
    if (const auto& step = player->past()[i]; step.actor == *actor)
      frames.push_back(frame(FrameKey{thread, i + 1, true}.id(), lineOf(step, ""), step.place));
  if (frames.empty())
    frames.push_back(frame(FrameKey{thread, player->position(), false}.id(), "nothing yet", {}));
  const auto total = frames.size();
  const auto start = arguments.value("startFrame", std::size_t{0});
  const auto levels = arguments.value("levels", std::size_t{0});
  Json shown = Json::array();
  for (auto i = start; i < total && (levels == 0 || i < start + levels); ++i)
    shown.push_back(std::move(frames[i]));
  return Json{{"stackFrames", shown}, {"totalFrames", total}};
}

Adapter::Answer Adapter::scopes(const Json& arguments) {
  const auto key = FrameKey::of(arguments.at("frameId").get<long long>());
  if (key.position > player->position()) return std::unexpected("there is no such frame");
  const auto scope = [&](const char* name, Scope which) {
    return Json{
        {"name", name}, {"variablesReference", referenceOf(key, which)}, {"expensive", false}};
  };
  return Json{
      {"scopes", Json::array({scope("State variables", Scope::StateVariables),
                              scope("Skills", Scope::Skills), scope("Time", Scope::Time)})}};
}

Adapter::Answer Adapter::variables(const Json& arguments) {
  const auto reference = arguments.at("variablesReference").get<long long>();
  const auto moment = (reference - 1) / kScopes;
  const auto position = static_cast<std::size_t>(moment / 2);
  const bool isPast = moment % 2 == 1;
  if (reference < 1 || position > player->position())
    return std::unexpected("there is no such scope");
  const auto scope = static_cast<Scope>((reference - 1) % kScopes);
  Json all = Json::array();
  if (scope == Scope::Time) {
    const Step* last = position > 0 ? &player->past()[position - 1] : nullptr;
    const Step* shown = isPast                          ? last
                        : position < player->position() ? &player->past()[position]
                        : player->choices().empty()     ? nullptr
                                                        : &player->choices().front();
    all.push_back(variable("now", last ? last->date + " s" : "0 s"));
    all.push_back(variable("steps taken", std::to_string(position)));
    if (!shown) return Json{{"variables", all}};
    all.push_back(variable(isPast ? "this step" : "next step", shown->date + " s"));
    all.push_back(variable("after", shown->delay + " s"));
    all.push_back(variable("possible", windowOf(*shown)));
    if (!shown->why.empty()) all.push_back(variable("why", ide::withoutBackticks(shown->why)));
    if (!player->trace().summary.empty())
      all.push_back(variable("relevant", shown->relevant ? "yes" : "no"));
    for (const auto& transition : shown->transitions)
      all.push_back(variable("transition", transition));
    return Json{{"variables", all}};
  }
  const auto before = player->valuesAt(position > 0 ? position - 1 : 0);
  const auto now = player->valuesAt(position);
  for (std::size_t i = 0; i < now.size(); ++i) {
    const auto& [name, value] = now[i];
    if (isStatus(name) != (scope == Scope::Skills)) continue;
    all.push_back(
        variable(name, value, value == before[i].second ? "" : "was " + before[i].second));
  }
  return Json{{"variables", all}};
}

Adapter::Answer Adapter::evaluate(const Json& arguments) {
  auto expression = arguments.at("expression").get<std::string>();
  const auto first = expression.find_first_not_of(" \t\r\n");
  const auto last = expression.find_last_not_of(" \t\r\n");
  expression = first == std::string::npos ? "" : expression.substr(first, last - first + 1);
  auto position = player->position();
  if (const auto id = arguments.value("frameId", Json()); id.is_number_integer())
    position = std::min(position, FrameKey::of(id.get<long long>()).position);
  const auto values = player->valuesAt(position);
  for (const auto& name : {expression, expression + ".status"})
    for (const auto& [variable, value] : values)
      if (variable == name) return Json{{"result", value}, {"variablesReference", 0}};
  return std::unexpected(fmt::format("there is no variable `{}`", expression));
}

} // namespace proskill::dap
