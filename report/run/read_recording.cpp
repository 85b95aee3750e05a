#include "report/run/read_recording.h"

#include "report/ordered_json.h"

namespace proskill::report {

namespace {

using Json = nlohmann::json;

struct Wrong {
  std::string why;
};

/// Parses a recording, which has one step per line. If it was cut off, the incomplete last line is
/// ignored.
Json parsed(std::string_view text) {
  auto whole = Json::parse(text, nullptr, false);
  while (whole.is_discarded()) {
    const auto line = text.rfind('\n');
    if (line == std::string_view::npos) throw Wrong{"it is not JSON"};
    text = text.substr(0, line);
    auto steps = std::string(text);
    while (!steps.empty() && (steps.back() == ',' || steps.back() == '\n')) steps.pop_back();
    whole = Json::parse(steps + "]}", nullptr, false);
  }
  return whole;
}

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

void locate(const Json& step, const analysis::Program& program, fiacre::Origin& what) {
  const auto found = step.find("location");
  if (found == step.end() || !found->is_object()) return;
  const auto bytes = found->find("bytes");
  if (bytes == found->end() || !bytes->is_array() || bytes->size() != 2) return;
  const auto name = std::filesystem::path(word(*found, "file")).filename();
  for (std::uint32_t i = 0; i < program.files.size(); ++i)
    if (program.files[i].path.filename() == name) what.file = i;
  what.begin = (*bytes)[0].is_number_unsigned() ? (*bytes)[0].get<std::uint32_t>() : 0;
  what.end = (*bytes)[1].is_number_unsigned() ? (*bytes)[1].get<std::uint32_t>() : 0;
}

runtime::RecordedStep stepOf(const Json& value, const analysis::Program& program) {
  runtime::RecordedStep step;
  step.date = dateOf(value);
  step.what.actor = word(value, "actor");
  step.what.description = word(value, "description");
  step.stops = word(value, "stops");
  locate(value, program, step.what);
  if (const auto changes = value.find("changes"); changes != value.end() && changes->is_array())
    for (const auto& change : *changes)
      if (change.is_object())
        step.changes.push_back(
            {word(change, "variable"), word(change, "before"), word(change, "after")});
  return step;
}

} // namespace

std::expected<runtime::RecordedRun, std::string>
readRecording(std::string_view text, const analysis::Program& program, std::string& main) {
  try {
    const auto value = parsed(text);
    if (!value.is_object() || !value.contains("steps") || !value["steps"].is_array())
      return std::unexpected("it has no steps");
    if (word(value, "verdict") != "recorded") return std::unexpected("it is not a recorded run");
    main = word(value, "main");
    runtime::RecordedRun run;
    run.environment = value.contains("environment") && value["environment"] == true;
    for (const auto& step : value["steps"]) {
      if (!step.is_object()) return std::unexpected("a step must be an object");
      if (!step.contains("remark")) run.steps.push_back(stepOf(step, program));
    }
    return run;
  } catch (const Wrong& wrong) {
    return std::unexpected(wrong.why);
  }
}

} // namespace proskill::report
