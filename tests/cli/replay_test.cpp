#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace proskill;
using Json = nlohmann::json;

namespace {

const std::string kDockToReplay = std::string(PROSKILL_SOURCE_DIR) + "/docs/tour/dock.proskill";

/// A saved run in a file of its own.
class SavedRun {
public:
  explicit SavedRun(const Json& run) : path(directory.write("saved.run.json", run.dump())) {}

  [[nodiscard]] test::Finished replayed() const {
    return test::run({PROSKILL_PROGRAM, "replay", kDockToReplay, path});
  }

private:
  test::TemporaryDirectory directory;
  std::string path;
};

Json stepsTo(const std::string& result) {
  return Json::array({{{"actor", "recharge"}, {"description", "starts"}},
                      {{"actor", "recharge"}, {"description", "calls `drive_onto_dock`"}},
                      {{"actor", "drive_onto_dock"}, {"description", "starts"}},
                      {{"actor", "watchdog of recharge"}, {"description", "starts measuring"}},
                      {{"actor", "drive_onto_dock"}, {"description", result}}});
}

} // namespace

TEST_CASE("a saved run that is possible and ends as expected passes") {
  const SavedRun run(
      {{"steps", stepsTo("succeeds with `docked`")}, {"expect", {{"place", "Dock"}}}});
  const auto done = run.replayed();
  CHECK(done.exitCode == 0);
  CHECK(done.out.starts_with("passed "));
  CHECK(done.out.ends_with(": 5 steps\n"));
}

TEST_CASE("a value that differs is named with the one that was expected") {
  const SavedRun run({{"steps", stepsTo("fails with `missed`")}, {"expect", {{"place", "Dock"}}}});
  const auto done = run.replayed();
  CHECK(done.exitCode == 1);
  CHECK(done.out.find("failed ") == 0);
  CHECK(done.out.find("`place` is Floor, expected Dock") != std::string::npos);
}

TEST_CASE("a step that is not possible is named with what happens instead") {
  const SavedRun run(Json::object({{"steps", stepsTo("succeeds with `arrived`")}}));
  const auto done = run.replayed();
  CHECK(done.exitCode == 1);
  CHECK(done.out.find("step 5 of 5 is not possible: `drive_onto_dock` succeeds with `arrived`; "
                      "now `drive_onto_dock` ") != std::string::npos);
}

TEST_CASE("what is not a run is an error, and so is a step without an actor") {
  for (const Json& wrong : {Json("text"), Json::object(), Json{{"steps", Json::array({1})}},
                            Json{{"steps", Json::array()}, {"expect", Json::array()}},
                            Json{{"steps", Json::array()}, {"expect", {{"place", 3}}}}}) {
    const SavedRun run(wrong);
    const auto done = run.replayed();
    CHECK(done.exitCode == 2);
    CHECK(done.err.find("is not a run: ") != std::string::npos);
  }
}

TEST_CASE("the run of the manual passes") {
  const auto run = std::string(PROSKILL_SOURCE_DIR) + "/docs/tour/charged.run.json";
  CHECK(test::run({PROSKILL_PROGRAM, "replay", kDockToReplay, run}).exitCode == 0);
}
