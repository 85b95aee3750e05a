#include "report/ordered_json.h"
#include "report/run/parts/recording_part.h"
#include "report/run/read_recording.h"
#include "tests/support/recorded.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

using namespace proskill;

namespace {

/// What is read of a trace: its mission, and its steps and starts of actions; or the error.
std::string readAs(const std::string& text) {
  const auto program = test::programOfText("(defskill m :body ((^ 1)))");
  runtime::KeptRun kept;
  if (const auto wrong = report::readRecording(test::fileOf(text), program, kept)) return *wrong;
  auto said = fmt::format("{}:", kept.run.head.mainSkill);
  for (const auto& step : kept.run.steps) said += fmt::format(" {}@{}", step.what.actor, step.date);
  for (const auto& call : kept.run.calls)
    said += fmt::format(" {}({}) after {}", call.skill, fmt::join(call.arguments, ","), call.after);
  return said;
}

std::string step(const std::string& actor, int seconds, const std::string& more = "") {
  return fmt::format(R"({{"actor":"{}","date":{{"exact":"{}"}}{}}})", actor, seconds, more);
}

std::string traceOf(const std::string& steps) {
  return R"({"verdict":"recorded","initial":{"steps":"1"},"steps":[)" + steps + R"(],"main":"m"})";
}

/// A step in the form of a recording.
std::string recordedStep(const std::string& date, const std::string& before = "") {
  return R"({)" + before + R"("actor":"m","date":{"exact":")" + date +
         R"("},"delay":{"exact":"0"},"changes":[],"why":""})";
}

/// A step that counts `n` up.
std::string recordedChange(int seconds) {
  return fmt::format(
      R"({{"actor":"m","date":{{"exact":"{0}"}},"changes":[{{"variable":"n","before":"{1}","after":"{0}"}}]}})",
      seconds, seconds - 1);
}

/// A file whose middle is repeated, of which no more than its parts are in memory.
struct LongFile {
  std::string begin;
  std::string middle;
  std::uint64_t times = 1;
  std::uint64_t largestRead = 0;

  report::mcap::File file() {
    const auto size = begin.size() + times * middle.size();
    return {size, [this, size](std::uint64_t at, std::uint64_t bytes) {
              largestRead = std::max(largestRead, bytes);
              std::string made;
              for (const auto end = std::min(at + bytes, size); at + made.size() < end;)
                made += partAt(at + made.size()).substr(0, end - at - made.size());
              return made;
            }};
  }

private:
  [[nodiscard]] std::string_view partAt(std::uint64_t at) const {
    if (at < begin.size()) return std::string_view(begin).substr(at);
    return std::string_view(middle).substr((at - begin.size()) % middle.size());
  }
};

constexpr std::uint64_t kStepsInMiddle = 5'000;
constexpr std::string_view kHead = R"({"verdict":"recorded","main":"m")";

LongFile longTrace() {
  LongFile made{.begin = std::string(kHead) + ",\"steps\":[\n", .middle = ""};
  for (std::uint64_t i = 0; i < kStepsInMiddle; ++i)
    made.middle += recordedStep(std::to_string(i)) + ",\n";
  return made;
}

LongFile longMcap() {
  namespace mcap = report::mcap;
  LongFile made;
  mcap::addHead(made.begin);
  mcap::addMetadata(made.begin, report::kTraceHead, "trace", std::string(kHead) + "}");
  mcap::addChannel(made.begin, 1, 0, "/steps");
  for (std::uint64_t i = 0; i < kStepsInMiddle; ++i)
    mcap::addMessage(made.middle, 1, 0, i, recordedStep(std::to_string(i)));
  mcap::Chunk chunk;
  chunk.size = made.middle.size();
  made.middle = mcap::chunkHead(chunk) + made.middle;
  return made;
}

/// Counts steps.
class Count final : public runtime::RunSink {
public:
  bool onHead(const runtime::RecordedHead&) override { return true; }
  bool onStep(const runtime::RecordedStep& step) override {
    sum += step.date / runtime::kSecond;
    return ++steps != most;
  }
  bool onCall(const runtime::RecordedCall&) override { return true; }

  std::uint64_t steps = 0;
  std::uint64_t most = 0;
  runtime::Nanoseconds sum = 0; ///< of the dates, in seconds
};

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

} // namespace

TEST_CASE("steps and starts of actions are read in their order") {
  const auto started = step("a", 1, R"(,"remark":"started","action":{"arguments":["x",2]})");
  CHECK(readAs(traceOf("")) == "m:");
  CHECK(readAs(traceOf(step("m", 1) + "," + started + "," + step("a", 2))) ==
        "m: m@1000000000 a@2000000000 a(x,2) after 1");
}

TEST_CASE("a recording without its end is read up to its last whole line") {
  const std::string head = R"({"verdict":"recorded","main":"m","steps":[)";
  CHECK(readAs(head + "\n" + step("m", 1) + ",\n" + step("m", 2) + ",\n{\"act") ==
        "m: m@1000000000 m@2000000000");
  CHECK(readAs(head) == "m:");
  CHECK(readAs("{\"verdict\":\"recor") == "it is not JSON");
}

TEST_CASE("what is no recording has an error") {
  CHECK(readAs(traceOf("3")) == "a step must be an object");
  CHECK(readAs(traceOf("{}")) == "a step has no date in whole nanoseconds");
  CHECK(readAs(R"({"verdict":"recorded"})") == "it has no steps");
  CHECK(readAs(R"({"verdict":"recorded","steps":{"a":{}}})") == "it has no steps");
  CHECK(readAs(R"({"verdict":"violated","steps":[]})") == "it is not a recorded run");
  CHECK(readAs(traceOf(step("m", 1, R"(,"x":)" + nested(100'000)))) ==
        "its values are nested too deeply");
  CHECK(readAs(nested(100'000)) == "its values are nested too deeply");
  CHECK(readAs("[]") == "it has no steps");
}

TEST_CASE("steps that say the same have dates of their own") {
  const auto decoy = R"("x":{"y":0,"date":{"exact":"1"},"changes":[]},)";
  CHECK(readAs(std::string(kHead) + ",\"steps\":[\n" + recordedStep("1") + ",\n" +
               recordedStep("2.5") + ",\n" + recordedStep("1", decoy) + ",\n" +
               recordedStep("4", decoy) + "\n]}\n") ==
        "m: m@1000000000 m@2500000000 m@1000000000 m@4000000000");
  const auto late = [](const std::string& date, const std::string& lag) {
    auto text = recordedStep(date);
    text.pop_back();
    return text + R"(,"lag":)" + lag + "},\n";
  };
  CHECK(readAs(std::string(kHead) + ",\"steps\":[\n" + late("1", "0.5") + late("2", "0.25") +
               late("3", R"(1,"remark":"note")") + late("4", "1e-9") + "]}\n") ==
        "m: m@1000000000 m@2000000000 m@4000000000");
}

TEST_CASE(
    "a trace with steps in lines is read to its end, whatever form it has from some line on") {
  const auto begin = std::string(kHead) + ",\"steps\":[\n";
  const auto one = recordedStep("1");
  const auto two = recordedStep("2");
  const auto both = "m: m@1000000000 m@2000000000";
  for (const auto& rest : {one + "," + two + "\n]}\n", one + ",\n" + two + "]}\n",
                           one + "," + two + "]}", one + ",\n{\n" + two.substr(1) + "\n]\n}\n",
                           one + ",\n" + two + ",", one + ",\n" + two + ",\n" + two.substr(0, 20),
                           one + ",\n" + two + ",\n" + std::string(9, '\0')}) {
    INFO(rest);
    CHECK(readAs(begin + rest) == both);
  }
  CHECK(readAs(begin + one + ",\n" + two + "\n],\"main\":\"other\"}\n") ==
        "its steps are not its last member");
  CHECK(readAs(begin + one + ",\n{\n" + two + "\n]}\n") == "it is not JSON");
}

TEST_CASE("steps that differ between their dates and their changes are different steps") {
  const auto step = [](const std::string& actor, const std::string& date) {
    return R"({"kind":"step","date":{"exact":")" + date + R"("},"actor":")" + actor +
           "\",\"changes\":[]},\n";
  };
  CHECK(readAs(std::string(kHead) + ",\"steps\":[\n" + step("m", "1") + step("n", "2") + "]}\n") ==
        "m: m@1000000000 n@2000000000");
}

TEST_CASE("a step with its dates in another place is read as such") {
  const std::string dates = R"(,"date":{"exact":"1"})";
  const auto with = [](const std::string& inner, const std::string& outer) {
    return R"({"actor":"m","x":{"y":0)" + inner + "}" + outer + "},\n";
  };
  CHECK(readAs(std::string(kHead) + ",\"steps\":[\n" + with("", dates) + with(dates, "") +
               "]}\n") == "a step has no date in whole nanoseconds");
}

TEST_CASE("a recording of any length is read in small parts, up to what is wanted") {
  const auto program = test::programOfText("(defskill m :body ((^ 1)))");
  for (auto recording : {longTrace(), longMcap()}) {
    INFO(recording.begin);
    recording.times = (std::uint64_t{16} << 20) / recording.middle.size();
    Count all;
    CHECK(report::readRecording(recording.file(), program, all).value_or("") == "");
    CHECK(all.steps == recording.times * kStepsInMiddle);
    CHECK(all.sum / (kStepsInMiddle - 1) == all.steps / 2);
    CHECK(recording.largestRead <= std::uint64_t{1} << 20);
    Count some;
    some.most = 10;
    CHECK(report::readRecording(recording.file(), program, some).value_or("") == "");
    CHECK(some.steps == 10);
  }
}

TEST_CASE("a long trace in another form is an error") {
  const auto program = test::programOfText("(defskill m :body ((^ 1)))");
  LongFile vast{.begin = "{\n", .middle = "  \n", .times = std::uint64_t{1} << 40};
  Count all;
  CHECK(report::readRecording(vast.file(), program, all) ==
        "it is larger than 256 MiB, and does not have a step in each line");
}

TEST_CASE("a part of a long trace begins at a date of its run, with the values of then") {
  auto text = std::string(kHead) + R"(,"initial":{"n":"-1","x":"1"},"steps":[)" + "\n";
  for (int i = 0; i < 30'000; ++i) text += recordedChange(i) + ",\n";
  for (const auto* const end : {"", "]}\n", "{\"actor\":\"m\",\"da"}) {
    const auto all = text + end;
    const auto recording = test::fileOf(all);
    const report::PartOfRun wanted{.from = 15'000, .bytes = 1};
    CHECK(report::isShownInParts(recording, wanted));
    CHECK_FALSE(report::isShownInParts(recording, {}));
    const auto part = report::traceOfPart(recording, wanted);
    REQUIRE(part);
    CHECK(part->begin <= 15'000);
    CHECK(part->end >= 15'000);
    CHECK(part->length == 29'999);
    const auto trace = OrderedJson::parse(part->text);
    const auto first = static_cast<int>(part->begin);
    CHECK(trace["initial"]["n"] == std::to_string(first - 1));
    CHECK(trace["initial"]["x"] == "1");
    CHECK(trace["steps"].front() == OrderedJson::parse(recordedChange(first)));
    CHECK(trace["steps"].size() == static_cast<std::size_t>(part->end - part->begin) + 1);
    CHECK(report::traceOfPart(recording, {.bytes = 1})->end == 29'999);
    CHECK(report::traceOfPart(recording, {})->isWhole);
    CHECK(report::traceOfPart(recording, {})->text == text.substr(0, text.size() - 2) + "\n]}\n");
  }
}

TEST_CASE("a damaged line within a long trace is an error") {
  const auto head = std::string(kHead) + R"(,"steps":[)" + "\n" + recordedChange(0) + ",\n";
  const auto partOf = [&](const std::string& rest) {
    const auto part = report::traceOfPart(test::fileOf(head + rest), {.from = 0});
    return part ? fmt::format("to {} s", part->end) : part.error();
  };
  const auto step = recordedChange(1);
  CHECK(partOf("garbage\n" + step + "\n]}\n") == "line 3 is not a step");
  CHECK(partOf(step + ",\n" + step.substr(0, 20) + "\n]}\n") == "line 4 is not a step");
  CHECK(partOf(step + ",\ngarbage") == "to 1 s");
  CHECK(partOf(step + "\n]\n}\n") == "to 1 s");
}

TEST_CASE("a trace that is too large to be shown as a whole is read in small parts") {
  auto vast = longTrace();
  CHECK_FALSE(report::isShownInParts(vast.file(), {}));
  vast.times = (std::uint64_t{16} << 20) / vast.middle.size();
  const auto part = report::traceOfPart(vast.file(), {.bytes = std::uint64_t{1} << 20});
  REQUIRE(part);
  CHECK_FALSE(part->isWhole);
  CHECK(part->text.size() < std::size_t{2} << 20);
  CHECK(vast.largestRead < std::uint64_t{2} << 20);
  vast.times = std::uint64_t{1} << 40;
  CHECK(report::isShownInParts(vast.file(), {}));
  vast.begin = "{\n";
  CHECK_FALSE(report::isShownInParts(vast.file(), {}));
}

TEST_CASE("a trace that is too large to be shown comes with an advice") {
  auto vast = longTrace();
  CHECK(report::whyNotShown(vast.file(), "no") == "no");
  vast.times = 10'000;
  CHECK(report::whyNotShown(vast.file(), "no").starts_with("no; long runs are shown in parts"));
  vast.begin = "text";
  CHECK(report::whyNotShown(vast.file(), "no") == "no");
}
