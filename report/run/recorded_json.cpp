#include "report/run/recorded_json.h"

#include "report/ordered_json.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace proskill::report {

using Json = nlohmann::json;

namespace {

// a damaged recording may have any number of texts and paths, of any length
constexpr std::size_t kMostKept = 1'000;
constexpr std::size_t kLongestKept = 4'096;

std::string word(const Json& value, const char* key) {
  const auto found = value.find(key);
  return found != value.end() && found->is_string() ? found->get<std::string>() : "";
}

/// A time in seconds, as an exact number, if it is in whole nanoseconds.
std::optional<runtime::Nanoseconds> nanosecondsOf(std::string_view exact) {
  const auto seconds = syntax::parseRational(exact);
  const auto date = seconds ? syntax::multiply(*seconds, {runtime::kSecond, 1}) : std::nullopt;
  if (!date || date->denominator != 1) return std::nullopt;
  return date->numerator;
}

runtime::Nanoseconds dateOf(const Json& step) {
  const auto found = step.find("date");
  const auto date = found != step.end() && found->is_object() ? nanosecondsOf(word(*found, "exact"))
                                                              : std::nullopt;
  if (!date) throw WrongRecording{"a step has no date in whole nanoseconds"};
  return *date;
}

/// Where the text of a step has its dates.
struct Dated {
  std::size_t begin = 0;
  std::size_t end = 0;
  runtime::Nanoseconds date = 0;
};

/// End of the objects with dates that follow each other from a place on. What they have after
/// `exact` is not read.
std::size_t endOfDates(std::string_view step, std::size_t begin) {
  for (const std::string_view name : {"date", "delay", "earliest", "latest"}) {
    const auto rest = step.substr(begin);
    const bool isNext = rest.starts_with(",\"") && rest.substr(2).starts_with(name) &&
                        rest.substr(2 + name.size()).starts_with("\":{");
    const auto end = isNext ? rest.find('}') : std::string_view::npos;
    if (end != std::string_view::npos) begin += end + 1;
  }
  return begin;
}

/// In the form of a recording, which has all dates one after the other. Other texts may have none.
std::optional<Dated> datedIn(std::string_view step) {
  constexpr std::string_view kBegin = ",\"date\":{\"exact\":\"";
  const auto begin = step.find(kBegin);
  if (begin == std::string_view::npos) return std::nullopt;
  const auto number = step.substr(begin + kBegin.size());
  const auto date = nanosecondsOf(number.substr(0, number.find('"')));
  if (!date) return std::nullopt;
  return Dated{.begin = begin, .end = endOfDates(step, begin), .date = *date};
}

/// What follows the dates, but for how late the step was, which is not read.
std::string_view withoutLag(std::string_view rest) {
  constexpr std::string_view kLag = ",\"lag\":";
  const auto at = rest.rfind(kLag);
  if (at == std::string_view::npos || !rest.ends_with('}')) return rest;
  const auto number = rest.substr(at + kLag.size(), rest.size() - 1 - at - kLag.size());
  const bool isLast = number.find_first_not_of("0123456789.e+-") == std::string_view::npos;
  return isLast ? rest.substr(0, at) : rest;
}

/// Whether what follows the beginning of a text of JSON is a member of its outermost object.
bool isOutermost(std::string_view beginning) {
  int depth = 0;
  bool isString = false;
  for (std::size_t i = 0; i < beginning.size(); ++i) {
    const char c = beginning[i];
    if (isString && c == '\\') ++i;
    if (c == '"') isString = !isString;
    if (isString) continue;
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
  }
  return depth == 1 && !isString;
}

template <class Entry> void setDate(Entry& entry, runtime::Nanoseconds date) {
  if (auto* step = std::get_if<runtime::RecordedStep>(&entry)) step->date = date;
  if (auto* call = std::get_if<runtime::RecordedCall>(&entry)) call->date = date;
}

/// The file of a program with this path, which the recording may have seen from another folder.
std::optional<std::uint32_t> bestFile(const std::filesystem::path& path,
                                      const analysis::Program& program) {
  const std::vector<std::filesystem::path> wanted(path.begin(), path.end());
  std::optional<std::uint32_t> found;
  std::ptrdiff_t most = 0;
  for (std::uint32_t i = 0; i < program.files.size(); ++i) {
    const std::vector<std::filesystem::path> parts(program.files[i].path.begin(),
                                                   program.files[i].path.end());
    const auto common =
        std::ranges::mismatch(wanted.rbegin(), wanted.rend(), parts.rbegin(), parts.rend()).in1 -
        wanted.rbegin();
    if (common > most) {
      most = common;
      found = i;
    }
  }
  return found;
}

std::vector<verify::Change> initialOf(const Json& value) {
  std::vector<verify::Change> all;
  const auto initial = value.find("initial");
  if (initial == value.end() || !initial->is_object()) return all;
  for (const auto& [variable, first] : initial->items())
    all.push_back({variable, "", first.is_string() ? first.get<std::string>() : first.dump()});
  return all;
}

} // namespace

runtime::RecordedHead recordedHead(const Json& trace) {
  if (!trace.is_object() || word(trace, "verdict") != "recorded")
    throw WrongRecording{"it is not a recorded run"};
  const auto environment = trace.find("environment");
  return {.mainSkill = word(trace, "main"),
          .environment = environment != trace.end() && *environment == true,
          .initial = initialOf(trace)};
}

bool StepReader::pass(const Json& step, runtime::RunSink& to) {
  auto entry = entryOf(step);
  return pass(entry, to);
}

StepReader::Entry StepReader::entryOf(const Json& value) {
  if (!value.is_object()) throw WrongRecording{"a step must be an object"};
  if (!value.contains("remark")) return stepOf(value);
  if (word(value, "remark") == "started") return callOf(value);
  return {};
}

bool StepReader::pass(Entry& entry, runtime::RunSink& to) {
  if (const auto* step = std::get_if<runtime::RecordedStep>(&entry)) {
    ++count;
    return to.onStep(*step);
  }
  auto* call = std::get_if<runtime::RecordedCall>(&entry);
  if (!call) return true;
  call->after = count;
  return to.onCall(*call);
}

std::optional<bool> StepReader::pass(std::string_view step, runtime::RunSink& to) {
  const auto dated = datedIn(step);
  if (dated) {
    key.assign(step.substr(0, dated->begin)) += '\n'; // where the dates were
    key += withoutLag(step.substr(dated->end));
    if (const auto known = entries.find(key); known != entries.end()) {
      setDate(known->second, dated->date);
      return pass(known->second, to);
    }
  }
  if (runtime::isTooDeep(step)) throw WrongRecording{"its values are nested too deeply"};
  const auto value = Json::parse(step, nullptr, false);
  if (value.is_discarded()) return std::nullopt;
  auto entry = entryOf(value);
  if (dated && isOutermost(step.substr(0, dated->begin)) && dateOf(value) == dated->date)
    keep(entry);
  return pass(entry, to);
}

void StepReader::keep(const Entry& entry) {
  if (key.size() > kLongestKept) return;
  if (entries.size() == kMostKept) entries.clear();
  entries.emplace(key, entry);
}

runtime::RecordedStep StepReader::stepOf(const Json& value) {
  runtime::RecordedStep step;
  step.date = dateOf(value);
  step.what.actor = word(value, "actor");
  step.what.description = word(value, "description");
  step.stops = word(value, "stops");
  step.message = word(value, "message");
  locate(value, step.what);
  if (const auto changes = value.find("changes"); changes != value.end() && changes->is_array())
    for (const auto& change : *changes)
      if (change.is_object())
        step.changes.push_back(
            {word(change, "variable"), word(change, "before"), word(change, "after")});
  return step;
}

runtime::RecordedCall StepReader::callOf(const Json& remark) {
  runtime::RecordedCall call{0, dateOf(remark), word(remark, "actor"), "", {}};
  const auto action = remark.find("action");
  if (action == remark.end() || !action->is_object()) return call;
  call.command = word(*action, "command");
  if (const auto all = action->find("arguments"); all != action->end() && all->is_array())
    for (const auto& each : *all)
      call.arguments.push_back(each.is_string() ? each.get<std::string>() : each.dump());
  return call;
}

void StepReader::locate(const Json& step, fiacre::Origin& what) {
  const auto found = step.find("location");
  if (found == step.end() || !found->is_object()) return;
  const auto bytes = found->find("bytes");
  if (bytes == found->end() || !bytes->is_array() || bytes->size() != 2) return;
  what.file = fileNamed(word(*found, "file")).value_or(what.file);
  what.begin = (*bytes)[0].is_number_unsigned() ? (*bytes)[0].get<std::uint32_t>() : 0;
  what.end = (*bytes)[1].is_number_unsigned() ? (*bytes)[1].get<std::uint32_t>() : 0;
}

std::optional<std::uint32_t> StepReader::fileNamed(const std::string& path) {
  if (path.size() > kLongestKept) return bestFile(path, program);
  if (const auto known = files.find(path); known != files.end()) return known->second;
  if (files.size() == kMostKept) files.clear();
  return files[path] = bestFile(path, program);
}

} // namespace proskill::report
