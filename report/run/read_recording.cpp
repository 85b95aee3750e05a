#include "report/run/read_recording.h"

#include "report/ordered_json.h"
#include "report/run/mcap.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace proskill::report {

namespace {

using Json = nlohmann::json;

struct Wrong {
  std::string why;
};

std::string word(const Json& value, const char* key) {
  const auto found = value.find(key);
  return found != value.end() && found->is_string() ? found->get<std::string>() : "";
}

runtime::Nanoseconds dateOf(const Json& step) {
  const auto found = step.find("date");
  const auto exact = found != step.end() && found->is_object()
                         ? syntax::parseRational(word(*found, "exact"))
                         : std::nullopt;
  const auto date = exact ? syntax::multiply(*exact, {runtime::kSecond, 1}) : std::nullopt;
  if (!date || date->denominator != 1) throw Wrong{"a step has no date in whole nanoseconds"};
  return date->numerator;
}

/// The file of a program with this path, which the recording may have seen from another folder.
std::optional<std::uint32_t> fileNamed(const std::filesystem::path& path,
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

void locate(const Json& step, const analysis::Program& program, fiacre::Origin& what) {
  const auto found = step.find("location");
  if (found == step.end() || !found->is_object()) return;
  const auto bytes = found->find("bytes");
  if (bytes == found->end() || !bytes->is_array() || bytes->size() != 2) return;
  what.file = fileNamed(word(*found, "file"), program).value_or(what.file);
  what.begin = (*bytes)[0].is_number_unsigned() ? (*bytes)[0].get<std::uint32_t>() : 0;
  what.end = (*bytes)[1].is_number_unsigned() ? (*bytes)[1].get<std::uint32_t>() : 0;
}

runtime::RecordedStep stepOf(const Json& value, const analysis::Program& program) {
  runtime::RecordedStep step;
  step.date = dateOf(value);
  step.what.actor = word(value, "actor");
  step.what.description = word(value, "description");
  step.stops = word(value, "stops");
  step.message = word(value, "message");
  locate(value, program, step.what);
  if (const auto changes = value.find("changes"); changes != value.end() && changes->is_array())
    for (const auto& change : *changes)
      if (change.is_object())
        step.changes.push_back(
            {word(change, "variable"), word(change, "before"), word(change, "after")});
  return step;
}

runtime::RecordedCall callOf(const Json& remark, std::size_t after) {
  runtime::RecordedCall call{after, dateOf(remark), word(remark, "actor"), "", {}};
  const auto action = remark.find("action");
  if (action == remark.end() || !action->is_object()) return call;
  call.command = word(*action, "command");
  if (const auto all = action->find("arguments"); all != action->end() && all->is_array())
    for (const auto& each : *all)
      call.arguments.push_back(each.is_string() ? each.get<std::string>() : each.dump());
  return call;
}

std::vector<verify::Change> initialOf(const Json& value) {
  std::vector<verify::Change> all;
  const auto initial = value.find("initial");
  if (initial == value.end() || !initial->is_object()) return all;
  for (const auto& [variable, first] : initial->items())
    all.push_back({variable, "", first.is_string() ? first.get<std::string>() : first.dump()});
  return all;
}

/// Reads the steps one by one, so that no more than one of them is kept as JSON.
class RunReader {
public:
  explicit RunReader(const analysis::Program& of) : program(of) {}

  void step(const Json& step) {
    if (!step.is_object()) throw Wrong{"a step must be an object"};
    if (!step.contains("remark")) run.steps.push_back(stepOf(step, program));
    if (word(step, "remark") == "started") run.calls.push_back(callOf(step, run.steps.size()));
  }
  /// What a trace has beside its steps.
  void head(const Json& trace, std::string& main) {
    if (word(trace, "verdict") != "recorded") throw Wrong{"it is not a recorded run"};
    main = word(trace, "main");
    run.environment = trace.contains("environment") && trace["environment"] == true;
    run.initial = initialOf(trace);
  }

  runtime::RecordedRun run;

private:
  const analysis::Program& program;
};

constexpr int kDeepest = 1000; ///< values within each other

Json parsed(std::string_view text, const Json::parser_callback_t& each) {
  return Json::parse(
      text,
      [&](int depth, Json::parse_event_t event, Json& value) {
        if (depth > kDeepest) throw Wrong{"its values are nested too deeply"};
        return each(depth, event, value);
      },
      false);
}

Json parsed(std::string_view text) {
  auto value = parsed(text, [](int, Json::parse_event_t, Json&) { return true; });
  if (value.is_discarded()) throw Wrong{"it is not JSON"};
  return value;
}

/// A trace in one text; nothing if it is not JSON.
std::optional<runtime::RecordedRun>
runOfTrace(std::string_view text, const analysis::Program& program, std::string& main) {
  using Event = Json::parse_event_t;
  RunReader reader(program);
  bool isNamedSteps = false;
  bool isInSteps = false;
  const auto trace = parsed(text, [&](int depth, Event event, Json& value) {
    if (depth == 1 && event == Event::key) isNamedSteps = value == "steps";
    if (depth == 1 && event == Event::array_start) isInSteps = isNamedSteps;
    if (depth == 1 && event == Event::array_end) isInSteps = false;
    if (depth != 2 || event != Event::object_end || !isInSteps) return true;
    reader.step(value);
    return false; // it is not kept
  });
  if (trace.is_discarded()) return std::nullopt;
  const auto steps = trace.find("steps");
  if (steps == trace.end() || !steps->is_array()) throw Wrong{"it has no steps"};
  for (const auto& step : *steps) reader.step(step); // none of them is an object
  reader.head(trace, main);
  return std::move(reader.run);
}

runtime::RecordedRun runOfMcap(std::string_view bytes, const analysis::Program& program,
                               std::string& main) {
  const auto content = mcap::read(bytes, "/steps");
  if (!content) throw Wrong{content.error()};
  const auto head = content->metadata.find(std::string(kTraceHead));
  if (head == content->metadata.end() || !head->second.ends_with('}'))
    throw Wrong{"it was not recorded by `proskill run`, or by an older one"};
  RunReader reader(program);
  reader.head(parsed(head->second), main);
  for (const auto message : content->messages) reader.step(parsed(message));
  return std::move(reader.run);
}

} // namespace

std::string completed(std::string_view text) {
  // whole lines; or without the last one, which was cut
  const auto lines = text.substr(0, std::min(text.rfind('\n'), text.size()));
  for (auto rest : {text, lines}) {
    while (rest.ends_with(',') || rest.ends_with('\n')) rest.remove_suffix(1);
    auto whole = std::string(rest) + "]}";
    if (Json::accept(whole)) return whole;
  }
  return std::string(text);
}

std::string traceWith(std::string head, const std::vector<std::string_view>& steps) {
  head.back() = ',';
  head += "\"steps\":[\n";
  const char* between = "";
  for (const auto step : steps) {
    head += std::exchange(between, ",\n");
    head += step;
  }
  return head + "\n]}\n";
}

std::expected<runtime::RecordedRun, std::string>
readRecording(std::string_view recording, const analysis::Program& program, std::string& main) {
  try {
    if (mcap::isMcap(recording)) return runOfMcap(recording, program, main);
    if (auto run = runOfTrace(recording, program, main)) return std::move(*run);
    if (auto run = runOfTrace(completed(recording), program, main)) return std::move(*run);
    return std::unexpected("it is not JSON");
  } catch (const Wrong& wrong) {
    return std::unexpected(wrong.why);
  }
}

} // namespace proskill::report
