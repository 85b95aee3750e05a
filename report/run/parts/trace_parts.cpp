#include "report/run/lines.h"
#include "report/run/parts/run_parts.h"
#include "report/run/read_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace proskill::report {

namespace {

constexpr std::uint64_t kStretch = std::uint64_t{1} << 20; ///< bytes

/// The line without the comma after a step.
std::string_view stepIn(std::string_view line) {
  if (line.ends_with(',')) line.remove_suffix(1);
  return line;
}

/// The values of variables along a run, and the date.
class Values final : public runtime::RunSink {
public:
  bool onHead(const runtime::RecordedHead& head) override {
    for (const auto& [variable, before, first] : head.initial) now[variable] = first;
    return true;
  }
  bool onStep(const runtime::RecordedStep& step) override {
    for (const auto& [variable, before, after] : step.changes) now[variable] = after;
    date = step.date;
    return true;
  }
  bool onCall(const runtime::RecordedCall& call) override {
    date = call.date;
    return true;
  }

  std::map<std::string, std::string> now;
  runtime::Nanoseconds date = 0;
};

class TraceParts final : public RunParts {
public:
  explicit TraceParts(const mcap::File& file) {
    Lines lines(file);
    const auto head = headOfLines(lines.next().value_or(""));
    if (!head) return;
    trace = parsedJson(*head);
    trace.erase("steps");
    values.onHead(recordedHead(runtime::parsedText(*head)));
    takeSteps(lines, file.size);
  }

  [[nodiscard]] std::expected<std::vector<std::string_view>, std::string>
  steps(std::string_view bytes) const override {
    std::vector<std::string_view> found;
    while (!bytes.empty()) {
      const auto end = std::min(bytes.find('\n'), bytes.size() - 1);
      const auto step = stepIn(bytes.substr(0, bytes[end] == '\n' ? end : end + 1));
      if (!step.empty()) found.push_back(step);
      bytes.remove_prefix(end + 1);
    }
    return found;
  }

  [[nodiscard]] std::map<std::string, std::string> valuesAt(std::size_t stretch,
                                                            std::string_view) const override {
    return valuesBefore[stretch];
  }

private:
  /// The last line may have been cut off.
  void takeSteps(Lines& lines, std::uint64_t size) {
    auto place = lines.position();
    for (std::size_t number = 2; const auto line = lines.next(); ++number) {
      if (isEnd(stepIn(*line))) return;
      if (!take(place, *line, lines.position())) {
        if (lines.position() >= size) return;
        throw WrongRecording{fmt::format("line {} is not a step", number)};
      }
      place = lines.position();
    }
  }

  /// Other tools write the end in two lines.
  static bool isEnd(std::string_view line) { return line == "]}" || line == "]"; }

  /// \return whether the line is a step
  bool take(std::uint64_t place, std::string_view line, std::uint64_t end) {
    const auto step = stepIn(line);
    const bool isNew = all.empty() || all.back().size >= kStretch;
    std::map<std::string, std::string> before;
    if (isNew) before = values.now;
    if (!step.empty() && !reader.pass(step, values)) return false;
    const auto date = static_cast<std::uint64_t>(std::max<runtime::Nanoseconds>(values.date, 0));
    if (isNew) {
      // the run begins at 0, whenever its first step is
      all.push_back({.at = place, .first = all.empty() ? 0 : date});
      valuesBefore.push_back(std::move(before));
    }
    all.back().size = end - all.back().at;
    all.back().last = date;
    return true;
  }

  const analysis::Program none; ///< in whose files the places of steps are not looked for
  StepReader reader{none};
  Values values;
  std::vector<std::map<std::string, std::string>> valuesBefore; ///< by stretch
};

} // namespace

FoundParts partsOfTrace(const mcap::File& file) {
  try {
    auto parts = std::make_unique<TraceParts>(file);
    if (!parts->head().is_object()) return std::unexpected("it does not have a step in each line");
    return parts;
  } catch (const WrongRecording& wrong) {
    return std::unexpected(wrong.why);
  }
}

} // namespace proskill::report
