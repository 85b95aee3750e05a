#include "report/ordered_json.h"
#include "report/run/parts/recording_part.h"
#include "report/run/run_report.h"
#include "runtime/platform/simulated.h"
#include "tests/support/recorded.h"
#include "tests/support/texts.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <random>
#include <sstream>

using namespace proskill;
namespace mcap = report::mcap;
using test::fileOf;

namespace {

/// One write to the file: at a place, over what was there.
struct Write {
  std::uint64_t at = 0;
  std::string bytes;
};

/// Everything that a run writes to its recording.
struct Written {
  std::vector<Write> writes;

  /// The file after some writes, and a part of the next.
  [[nodiscard]] std::string after(std::size_t count, std::size_t torn = 0) const {
    std::string file;
    const auto apply = [&](const Write& write, std::size_t size) {
      file.resize(std::max<std::size_t>(file.size(), write.at + size));
      file.replace(write.at, size, write.bytes.substr(0, size));
    };
    for (std::size_t i = 0; i < count; ++i) apply(writes[i], writes[i].bytes.size());
    if (torn > 0) apply(writes[count], torn);
    return file;
  }
};

Written recordDrone(std::size_t chunkSize, std::uint64_t seed) {
  std::ifstream text(PROSKILL_SOURCE_DIR "/examples/drone/drone.proskill");
  std::stringstream program;
  program << text.rdbuf();
  const auto drone = test::programOfText(program.str());
  const auto executable = runtime::makeExecutable(drone, "", true);
  REQUIRE(executable);
  Written written;
  std::uint64_t length = 0;
  {
    const auto recording = report::runMcap(
        {[&](std::string_view bytes, std::string_view end) {
           written.writes.push_back({length, std::string(bytes) + std::string(end)});
           length += bytes.size();
         },
         [&](std::uint64_t at, std::string_view bytes) {
           written.writes.push_back({at, std::string(bytes)});
         }},
        {drone, **executable}, 7'000'000'000, chunkSize);
    const auto clock = runtime::simulatedClock();
    const auto platform = simulatedPlatform(defaultSettings(**executable), seed);
    std::ignore = execute(**executable, *clock, *platform, *recording, {});
  }
  return written;
}

std::vector<std::string> stepsIn(const std::string& file) {
  std::vector<std::string> steps;
  const auto wrong = mcap::readMessages(fileOf(file), "/steps", [&](std::string_view step) {
    steps.emplace_back(step);
    return true;
  });
  INFO(wrong.value_or(""));
  REQUIRE_FALSE(wrong);
  return steps;
}

OrderedJson partOf(const std::string& file, const report::PartOfRun& part) {
  const auto text = traceOfPart(fileOf(file), part);
  if (!text) FAIL(text.error());
  return OrderedJson::parse(text->text);
}

std::vector<std::string> dumped(const OrderedJson& steps) {
  std::vector<std::string> texts;
  for (const auto& step : steps) texts.push_back(step.dump());
  return texts;
}

bool isPrefix(const std::vector<std::string>& part, const std::vector<std::string>& all) {
  return part.size() <= all.size() && std::equal(part.begin(), part.end(), all.begin());
}

/// Values after steps.
void apply(OrderedJson& values, const OrderedJson& steps, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    for (const auto& change : steps[i]["changes"])
      values[change["variable"].get<std::string>()] = change["after"];
}

} // namespace

TEST_CASE("a recording that is cut off in any write has all steps of the writes before") {
  std::mt19937 random(1); // NOLINT(cert-msc32-c, cert-msc51-cpp): the same each time
  for (const std::size_t chunkSize : {600, 4'000, 60'000}) {
    const auto written = recordDrone(chunkSize, 1);
    const auto& writes = written.writes;
    const auto all = stepsIn(written.after(writes.size()));
    CHECK(all.size() > 20);
    std::size_t known = 0;
    for (std::size_t count = 1; count <= writes.size(); ++count) {
      const auto whole = stepsIn(written.after(count));
      CHECK(isPrefix(whole, all));
      CHECK(whole.size() >= known);
      known = whole.size();
      if (count == writes.size()) break;
      const auto torn = 1 + random() % writes[count].bytes.size();
      const auto cut = written.after(count, torn);
      // The head of a chunk lies within a page, so no kill divides it.
      if (writes[count].bytes.size() == mcap::kChunkHead && writes[count].at + 1 < cut.size()) {
        CHECK(writes[count].at / 4096 == (writes[count].at + mcap::kChunkHead - 1) / 4096);
        continue;
      }
      CHECK(stepsIn(cut).size() >= known);
      CHECK(isPrefix(stepsIn(cut), all));
    }
  }
}

TEST_CASE(
    "a recording that was copied up to any byte is read up to there, with and without index") {
  std::mt19937 random(2); // NOLINT(cert-msc32-c, cert-msc51-cpp): the same each time
  const auto written = recordDrone(5'000, 2);
  const auto file = written.after(written.writes.size());
  const auto all = stepsIn(file);
  CHECK(dumped(partOf(file, {})["steps"]) ==
        dumped(partOf(file.substr(0, file.size() - 1), {})["steps"]));
  CHECK(partOf(file, {})["steps"].size() == all.size());
  for (int i = 0; i < 300; ++i) {
    const auto part = file.substr(0, 3'000 + random() % (file.size() - 3'000));
    INFO(part.size());
    const auto steps = stepsIn(part);
    CHECK(isPrefix(steps, all));
    CHECK(partOf(part, {})["steps"].size() == steps.size());
    // At most what the part does not contain as a whole is missing.
    CHECK((steps.size() == all.size() || !part.contains(all[steps.size()])));
  }
}

TEST_CASE("a part of a recording begins with the values of its first step") {
  const auto written = recordDrone(3'000, 3);
  const auto whole = written.after(written.writes.size());
  const auto unfinished = written.after(written.writes.size() - 1);
  const auto trace = partOf(whole, {});
  const auto all = dumped(trace["steps"]);
  CHECK(trace["description"] == "a recorded run of `uav_mission`");
  for (const auto& file : {whole, unfinished})
    for (const double from : {0.0, 1.0, 20.0, 60.0, 1e6}) {
      const auto part = partOf(file, {.from = from, .bytes = 8'000});
      const auto steps = dumped(part["steps"]);
      INFO(from << part["description"]);
      REQUIRE(!steps.empty());
      CHECK(steps.size() < all.size());
      const auto begin = std::search(all.begin(), all.end(), steps.begin(), steps.end());
      REQUIRE(begin != all.end());
      auto values = trace["initial"];
      apply(values, trace["steps"], static_cast<std::size_t>(begin - all.begin()));
      CHECK(part["initial"] == values);
      CHECK(
          part["description"].get<std::string>().starts_with("a recorded run of `uav_mission`: "));
    }
  const auto last = dumped(partOf(whole, {.bytes = 1})["steps"]);
  CHECK(last.back() == all.back());
  CHECK(last.size() < all.size());
}

TEST_CASE("a damaged recording is read, or is an error") {
  std::mt19937 random(5); // NOLINT(cert-msc32-c, cert-msc51-cpp): the same each time
  const auto written = recordDrone(4'000, 5);
  const auto whole = written.after(written.writes.size());
  std::size_t readable = 0;
  constexpr int kTimes = 2'000;
  for (int i = 0; i < kTimes; ++i) {
    auto file = whole;
    for (auto count = 1 + random() % 4; count > 0; --count) {
      // Numbers are damaged more often than texts, of which there are many more.
      const auto at =
          random() % 2 == 0 ? file.size() - 1 - random() % 1'000 : random() % file.size();
      file[at] = static_cast<char>(random());
    }
    std::ignore = mcap::readMessages(fileOf(file), "/steps", [](auto) { return true; });
    for (const auto from : {std::optional<double>(), std::optional(5.0)})
      readable += report::traceOfPart(fileOf(file), {.from = from, .bytes = 5'000}) ? 1 : 0;
  }
  CHECK(readable > kTimes / 2);
  CHECK(readable < 2 * kTimes);
}

TEST_CASE("chunks within chunks are an error, however deep") {
  std::string deep = "\x89MCAP0\r\n";
  for (int i = 0; i < 1'000'000; ++i) {
    mcap::Chunk chunk;
    chunk.size = std::uint64_t{49} * static_cast<std::uint64_t>(1'000'000 - i);
    deep += mcap::chunkHead(chunk);
  }
  const auto wrong = mcap::readMessages(fileOf(deep), "/steps", [](auto) { return true; });
  CHECK(wrong == "a chunk is within another");
}
