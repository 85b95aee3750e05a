#include "report/run/run_report.h"
#include "tests/runtime/run_of.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <map>
#include <set>

using namespace proskill;

namespace {

const std::string kLoads = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defsv loads :min 0 :max 9 :init 0)
  (defevent storm :effects (sky Stormy))
  (defevent clears :effects (sky Clear))
  (defskill load :time_interval [1,2] :action (load) :success loaded (:effects (loads 2))
    :failure dropped (:effects (loads 5)))
  (defskill mission :body ((while true (load) (set (loads 0)) (^ 1)))))";

/// What a page knows at the end: the values of the variables, and the place of each process.
struct Known {
  OrderedJson values;
  std::map<int, int> places;
  std::size_t notes = 0;
};

/// A run whose reader has no room for lines from `first` to `last`.
Known watched(std::size_t first, std::size_t last) {
  const auto program = test::programOfText(kLoads);
  const auto executable = test::executableOf(kLoads);
  const report::RunSubject subject{program, *executable};
  Known known{report::runHeadJson(subject)["initial"], {}, 0};
  std::size_t count = 0;
  const auto take = [&](std::string_view line) {
    if (++count >= first && count < last) return false;
    const auto step = OrderedJson::parse(line);
    for (const auto& change : step["changes"]) {
      auto& value = known.values[change["variable"].get<std::string>()];
      CHECK(value == change["before"]); // nothing is missing in between
      value = change["after"];
    }
    for (const auto& move : step.value("moves", OrderedJson::array()))
      known.places[move[0]] = move[1];
    known.notes +=
        step["description"].get<std::string>().ends_with("steps and remarks are not shown");
    return true;
  };
  const auto observer = report::runLive(take, subject);
  const auto platform = simulatedPlatform(defaultSettings(*executable), 3);
  const auto clock = runtime::simulatedClock();
  const auto result =
      execute(*executable, *clock, *platform, *observer, {.until = 90 * runtime::kSecond});
  CHECK(result.end == runtime::End::Until);
  return known;
}

} // namespace

TEST_CASE("a reader that misses steps learns how many, and what they changed") {
  const auto whole = watched(0, 0);
  CHECK(whole.notes == 0);
  for (std::size_t first = 1; first < 40; first += 3)
    for (const std::size_t missed : {1, 2, 5, 20}) {
      const auto part = watched(first, first + missed);
      INFO(first << ' ' << missed);
      CHECK(part.notes == 1);
      CHECK(part.values == whole.values);
      for (const auto& [process, place] : part.places) CHECK(whole.places.at(process) == place);
    }
}

TEST_CASE("the processes of a run are at statements of bodies and in actions") {
  const auto program = test::programOfText(kLoads);
  const auto executable = test::executableOf(kLoads);
  std::set<std::string> performing;
  std::set<std::string> moving;
  for (const auto& process : report::runPlacesJson({program, *executable})) {
    (process["performs"] == true ? performing : moving).insert(process["actor"]);
    CHECK(process["places"][process["start"].get<std::size_t>()].is_null());
  }
  CHECK(performing == std::set<std::string>{"load"});
  CHECK(moving == std::set<std::string>{"mission"});
}
