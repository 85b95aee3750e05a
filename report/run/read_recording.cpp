#include "report/run/read_recording.h"

#include "report/ordered_json.h"
#include "report/run/lines.h"
#include "report/run/recorded_json.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace proskill::report {

namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 1000; ///< values within each other
constexpr std::string_view kStepsBegin = "\"steps\":[";

Json parsed(std::string_view text, const Json::parser_callback_t& each) {
  return Json::parse(
      text,
      [&](int depth, Json::parse_event_t event, Json& value) {
        if (depth > kDeepest) throw WrongRecording{"its values are nested too deeply"};
        return each(depth, event, value);
      },
      false);
}

/// A trace in one text.
struct WholeTrace {
  Json beside; ///< without its steps
  runtime::RecordedRun run;
};

/// Nothing if it is not JSON. No more than one step is kept as JSON.
std::optional<WholeTrace> wholeTrace(std::string_view text, const analysis::Program& program) {
  using Event = Json::parse_event_t;
  StepReader reader(program);
  runtime::KeptRun kept; // more is known of it only after its steps
  bool isNamedSteps = false;
  bool isInSteps = false;
  auto trace = parsed(text, [&](int depth, Event event, Json& value) {
    if (depth == 1 && event == Event::key) isNamedSteps = value == "steps";
    if (depth == 1 && event == Event::array_start) isInSteps = isNamedSteps;
    if (depth == 1 && event == Event::array_end) isInSteps = false;
    if (depth != 2 || event != Event::object_end || !isInSteps) return true;
    (void)reader.pass(value, kept);
    return false; // it is not kept
  });
  if (trace.is_discarded()) return std::nullopt;
  const auto steps = trace.find("steps");
  if (steps == trace.end() || !steps->is_array()) throw WrongRecording{"it has no steps"};
  for (const auto& step : *steps) (void)reader.pass(step, kept); // none of them is an object
  return WholeTrace{std::move(trace), std::move(kept.run)};
}

/// Reads a trace as a whole, or what follows a place in it. \param begin text before that place
WholeTrace wholeTrace(const mcap::File& file, const analysis::Program& program,
                      std::string_view begin = "", std::uint64_t place = 0) {
  constexpr std::uint64_t kMost = std::uint64_t{256} << 20;
  if (file.size - place > kMost)
    throw WrongRecording{"it is larger than 256 MiB, and does not have a step in each line"};
  const auto text = std::string(begin) + file.read(place, file.size - place);
  auto trace = wholeTrace(text, program);
  if (!trace) trace = wholeTrace(completed(text), program);
  if (!trace) throw WrongRecording{"it is not JSON"};
  return std::move(*trace);
}

/// Reads a trace with a step in each line, as it is recorded. From the first line of another form
/// on, such as one that was cut off, it is read as a whole.
class TraceReader {
public:
  TraceReader(const mcap::File& of, const analysis::Program& in, runtime::RunSink& into)
      : file(of), program(in), lines(of), reader(in), to(into) {}

  void read() {
    const auto head = headOfLines(lines.next().value_or(""));
    if (!head) return readWhole();
    if (to.onHead(recordedHead(runtime::parsedText(*head)))) readSteps();
  }

private:
  void readWhole() {
    auto trace = wholeTrace(file, program);
    trace.run.head = recordedHead(trace.beside);
    (void)replay(trace.run, to);
  }

  void readSteps() {
    auto place = lines.position();
    while (const auto line = lines.next()) {
      if (*line == "]}") return;
      const auto isWanted = take(*line);
      if (!isWanted) return readStepsFrom(place);
      if (!*isWanted) return;
      place = lines.position();
    }
  }

  /// \return whether more is wanted; nothing if the line is not a step
  std::optional<bool> take(std::string_view line) {
    if (line.ends_with(',')) line.remove_suffix(1);
    return line.empty() ? true : reader.pass(line, to);
  }

  void readStepsFrom(std::uint64_t place) {
    const auto rest =
        wholeTrace(file, program, std::string("{") + std::string(kStepsBegin) + "\n", place);
    if (rest.beside.size() > 1) throw WrongRecording{"its steps are not its last member"};
    (void)replaySteps(rest.run, to);
  }

  const mcap::File& file;
  const analysis::Program& program;
  Lines lines;
  StepReader reader;
  runtime::RunSink& to;
};

void readMcap(const mcap::File& file, const analysis::Program& program, runtime::RunSink& to) {
  const auto head = mcap::metadataOf(file, kTraceHead);
  if (!head.ends_with('}'))
    throw WrongRecording{"it was not recorded by `proskill run`, or by an older one"};
  if (!to.onHead(recordedHead(runtime::parsedText(head)))) return;
  StepReader reader(program);
  const auto wrong = mcap::readMessages(file, "/steps", [&](std::string_view message) {
    const auto isWanted = reader.pass(message, to);
    if (!isWanted) throw WrongRecording{"it is not JSON"};
    return *isWanted;
  });
  if (wrong) throw WrongRecording{*wrong};
}

} // namespace

std::optional<std::string> headOfLines(std::string_view firstLine) {
  if (!firstLine.ends_with(kStepsBegin)) return std::nullopt;
  auto head = std::string(firstLine) + "]}";
  return Json::accept(head) ? std::optional(std::move(head)) : std::nullopt;
}

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

std::optional<std::string> readRecording(const mcap::File& recording,
                                         const analysis::Program& program, runtime::RunSink& to) {
  try {
    if (recording.isMcap())
      readMcap(recording, program, to);
    else
      TraceReader(recording, program, to).read();
    return std::nullopt;
  } catch (const WrongRecording& wrong) {
    return wrong.why;
  }
}

} // namespace proskill::report
