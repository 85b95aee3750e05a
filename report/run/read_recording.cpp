#include "report/run/read_recording.h"

#include "report/ordered_json.h"
#include "report/run/recorded_json.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace proskill::report {

namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 1000; ///< values within each other

Json parsed(std::string_view text, const Json::parser_callback_t& each) {
  return Json::parse(
      text,
      [&](int depth, Json::parse_event_t event, Json& value) {
        if (depth > kDeepest) throw WrongRecording{"its values are nested too deeply"};
        return each(depth, event, value);
      },
      false);
}

/// The lines of a file one after the other.
class Lines {
public:
  explicit Lines(const mcap::File& of) : file(of) {}

  /// Where the next line begins.
  [[nodiscard]] std::uint64_t position() const { return place - (buffer.size() - used); }
  /// The next line, without its end; nullopt after the last one. Valid until the next call.
  std::optional<std::string_view> next() {
    auto end = buffer.find('\n', used);
    while (end == std::string::npos && readMore()) end = buffer.find('\n', searched);
    if (end == std::string::npos && used == buffer.size()) return std::nullopt;
    const auto line = std::string_view(buffer).substr(used, end - used);
    used = std::min(end, buffer.size() - 1) + 1;
    return line;
  }

private:
  /// Keeps what was not returned yet.
  bool readMore() {
    constexpr std::uint64_t kBlock = std::uint64_t{1} << 20;
    buffer.erase(0, std::exchange(used, 0));
    searched = buffer.size();
    if (searched > kLongest) throw WrongRecording{"it has a line of more than 256 MiB"};
    const auto more = file.read(place, kBlock);
    place += more.size();
    buffer += more;
    return !more.empty();
  }

  static constexpr std::size_t kLongest = std::size_t{256} << 20;

  const mcap::File& file;
  std::uint64_t place = 0; ///< of what is read next
  std::string buffer;
  std::size_t used = 0; ///< what was returned
  std::size_t searched = 0;
};

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
    const auto first = lines.next();
    const auto head = first && first->ends_with(kBegin)
                          ? runtime::parsedText(std::string(*first) + "]}")
                          : Json(Json::value_t::discarded);
    if (head.is_discarded()) return readWhole();
    if (to.onHead(recordedHead(head))) readSteps();
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
        wholeTrace(file, program, std::string("{") + std::string(kBegin) + "\n", place);
    if (rest.beside.size() > 1) throw WrongRecording{"its steps are not its last member"};
    (void)replaySteps(rest.run, to);
  }

  static constexpr std::string_view kBegin = "\"steps\":[";

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
