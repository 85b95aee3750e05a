#include "lsp/verification/verified.h"

#include "report/ordered_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

namespace proskill::lsp {

namespace {

constexpr std::size_t kMostWaypoints = 40;

std::optional<ide::Verdict> verdictOf(std::string_view words) {
  using enum ide::Verdict;
  for (auto verdict : {Holds, Violated, Reachable, Unreachable, Inconclusive})
    if (words == ide::toString(verdict)) return verdict;
  return std::nullopt;
}

std::vector<ide::Waypoint> wayOf(const analysis::Program& program, const OrderedJson& trace) {
  std::vector<ide::Waypoint> way;
  for (const auto& step : trace.at("steps")) {
    auto location = locationIn(program, step.at("location"));
    if (!location || way.size() == kMostWaypoints) continue;
    way.push_back(
        {*location, fmt::format("{} s: {} {}", step.at("date").at("exact").get<std::string>(),
                                step.at("actor").get<std::string>(),
                                step.at("description").get<std::string>())});
  }
  return way;
}

/// Adds the setting that raises the limit to an inconclusive verdict.
std::string withSetting(const std::string& reason, const LimitSettings& limits) {
  const auto raisedBy = [&](std::string_view setting) {
    if (setting.empty()) return reason;
    return fmt::format("{}; the setting `{}` raises it", reason, setting);
  };
  if (reason.ends_with("the time limit was reached")) return raisedBy(limits.seconds);
  if (reason.ends_with("the memory limit was reached")) return raisedBy(limits.megabytes);
  return reason;
}

ide::PropertyVerdict propertyOf(const analysis::Program& program, const OrderedJson& json,
                                const LimitSettings& limits) {
  ide::PropertyVerdict property;
  property.name = json.at("name").get<std::string>();
  property.kind = json.at("kind").get<std::string>();
  property.subject = json.at("subject").get<std::string>();
  property.description = json.at("description").get<std::string>();
  property.verdict = verdictOf(json.at("verdict").get<std::string>()).value();
  property.weight =
      json.at("severity") == "error" ? codegen::Weight::Error : codegen::Weight::Warning;
  property.location = locationIn(program, json.at("location"));
  property.reason = withSetting(json.value("reason", ""), limits);
  if (const auto& steps = json.at("steps"); !steps.is_null())
    property.steps = steps.get<std::size_t>();
  if (const auto& trace = json.at("trace"); !trace.is_null()) {
    property.summary = trace.at("summary").get<std::string>();
    if (property.bad()) property.way = wayOf(program, trace);
  }
  return property;
}

void keepTrace(Verified& verified, const std::string& name, const OrderedJson& trace) {
  if (!trace.is_null()) verified.traces[name] = std::make_shared<const std::string>(trace.dump());
}

verify::Exploration explorationOf(const OrderedJson& json) {
  verify::Exploration exploration;
  exploration.classes = json.at("classes").get<std::uint64_t>();
  exploration.markings = json.at("markings").get<std::uint64_t>();
  exploration.domains = json.at("domains").get<std::uint64_t>();
  exploration.transitions = json.at("transitions").get<std::uint64_t>();
  exploration.bytes = json.at("bytes").get<std::uint64_t>();
  exploration.seconds = json.at("seconds").get<double>();
  exploration.complete = json.at("complete").get<bool>();
  exploration.stopped = json.at("stopped").get<std::string>();
  return exploration;
}

Verified read(const OrderedJson& report, std::shared_ptr<const ide::AnalysedProgram> analysed,
              const ide::OpenTexts& open, const LimitSettings& limits) {
  const auto& program = analysed->program;
  Verified verified;
  auto verdicts = std::make_shared<ide::ProgramVerdicts>();
  for (const auto& file : program.files)
    if (auto text = open.find(file.path); text != open.end())
      verdicts->versions[file.path] = text->second.version;
  for (const auto& json : report.at("properties")) {
    auto property = propertyOf(program, json, limits);
    keepTrace(verified, property.name, json.at("trace"));
    verdicts->properties.push_back(std::move(property));
  }
  verdicts->exploration = explorationOf(report.at("exploration"));
  verdicts->program = std::move(analysed);
  verified.verdicts = std::move(verdicts);
  if (const auto& main = report.at("main"); main.is_string())
    verified.mainSkill = main.get<std::string>();
  return verified;
}

void addRow(Verified& to, ide::ProgramVerdicts& verdicts, std::size_t row, const OrderedJson& json,
            const LimitSettings& limits) {
  auto property = propertyOf(verdicts.program->program, json, limits);
  keepTrace(to, property.name, json.at("trace"));
  verdicts.properties.at(row) = std::move(property);
}

} // namespace

std::optional<Verified> GrowingReport::with(const OrderedJson& report,
                                            const std::vector<std::size_t>& rows) {
  try {
    const bool isFirst = !known;
    if (isFirst) known = read(report, program, open, limits);
    auto verdicts = std::make_shared<ide::ProgramVerdicts>(*known->verdicts);
    if (isFirst)
      for (auto& property : verdicts->properties)
        property.pending = property.verdict == ide::Verdict::Inconclusive;
    for (auto row : rows) addRow(*known, *verdicts, row, report.at("properties").at(row), limits);
    known->verdicts = std::move(verdicts);
    return known;
  } catch (const OrderedJson::exception&) {
    return std::nullopt;
  } catch (const std::bad_optional_access&) {
    return std::nullopt;
  } catch (const std::out_of_range&) {
    return std::nullopt;
  }
}

std::optional<analysis::Location> locationIn(const analysis::Program& program,
                                             const OrderedJson& json) {
  if (!json.is_object()) return std::nullopt;
  const auto name = json.at("file").get<std::string>();
  auto file = std::ranges::find_if(
      program.files, [&](const analysis::File& it) { return it.path.generic_string() == name; });
  if (file == program.files.end()) return std::nullopt;
  const auto size = static_cast<syntax::Offset>(file->document.text().size());
  const auto bytes = json.at("bytes").get<std::array<syntax::Offset, 2>>();
  return analysis::Location{static_cast<analysis::FileId>(file - program.files.begin()),
                            {std::min(bytes[0], size), std::min(bytes[1], size)}};
}

std::optional<Verified> readReport(const OrderedJson& report,
                                   std::shared_ptr<const ide::AnalysedProgram> program,
                                   const ide::OpenTexts& open, const LimitSettings& limits) {
  try {
    return read(report, std::move(program), open, limits);
  } catch (const OrderedJson::exception&) {
    return std::nullopt;
  } catch (const std::bad_optional_access&) {
    return std::nullopt;
  }
}

namespace {

/// A moment in a report. Its exact value is a decimal number or a fraction.
ide::Moment momentIn(const OrderedJson& json) {
  const auto exact = json.at("exact").get<std::string>();
  return {syntax::parseRational(exact).value(), json.at("strict").get<bool>()};
}

std::optional<ide::MeasuredTime> timeIn(const OrderedJson& json) {
  if (json.is_null()) return std::nullopt;
  ide::MeasuredTime made{.happens = json.at("happens").get<bool>()};
  if (!made.happens) return made;
  made.bounded = !json.at("value").is_null();
  if (made.bounded) made.value = momentIn(json.at("value"));
  return made;
}

} // namespace

std::optional<std::vector<ide::SkillDuration>> readDurations(const OrderedJson& report) {
  try {
    std::vector<ide::SkillDuration> all;
    for (const auto& json : report.at("durations"))
      all.push_back({json.at("skill").get<std::string>(), timeIn(json.at("shortest")),
                     timeIn(json.at("longest"))});
    return all;
  } catch (const OrderedJson::exception&) {
    return std::nullopt;
  } catch (const std::bad_optional_access&) {
    return std::nullopt;
  }
}

Verified ofWholeProgram(Verified verified) {
  auto verdicts = std::make_shared<ide::ProgramVerdicts>(*verified.verdicts);
  verdicts->isWhole = true;
  verified.verdicts = std::move(verdicts);
  return verified;
}

namespace {

/// Whether a later verdict for the same texts counts: not if a decided one would become
/// inconclusive, or if verification still runs.
bool replaces(const ide::PropertyVerdict& newer, const ide::PropertyVerdict& older) {
  if (newer.verdict != ide::Verdict::Inconclusive) return true;
  return older.verdict == ide::Verdict::Inconclusive && (!newer.pending || older.pending);
}

} // namespace

Verified merged(const Verified& older, Verified newer) {
  if (!ide::areCurrent(*older.verdicts, newer.verdicts->program->program)) return newer;
  auto all = std::make_shared<ide::ProgramVerdicts>(*newer.verdicts);
  all->properties = older.verdicts->properties;
  if (all->durations.empty()) all->durations = older.verdicts->durations;
  all->isWhole = all->isWhole || older.verdicts->isWhole;
  std::unordered_map<std::string_view, std::size_t> rows; // an index of the older verdicts, of
                                                          // which there may be thousands
  for (const auto& property : older.verdicts->properties) rows.emplace(property.name, rows.size());
  std::unordered_set<std::string_view> again;
  for (const auto& property : newer.verdicts->properties) {
    const auto row = rows.find(property.name);
    if (row == rows.end())
      all->properties.push_back(property);
    else if (auto& known = all->properties[row->second]; replaces(property, known))
      known = property;
    else
      continue;
    again.insert(property.name);
  }
  // a property without a trace in the newer verdicts loses its older one
  for (const auto& [name, trace] : older.traces)
    if (!again.contains(name)) newer.traces.try_emplace(name, trace);
  newer.verdicts = std::move(all);
  return newer;
}

} // namespace proskill::lsp
