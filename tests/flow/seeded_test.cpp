#include "analysis/flow/inspect.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

using namespace proskill;

namespace {

namespace fs = std::filesystem;

/// A mistake made in an example, and what is to be said about it: one finding, at the place that
/// begins with `place`, and nothing else that was not said before.
struct Seed {
  const char* root; ///< below examples/
  const char* file;
  const char* from; ///< the first occurrence is replaced
  const char* to;
  const char* code;
  const char* place;
};

const Seed kSeeds[] = {
    // Moves.
    {"drone/drone.proskill", "drone.proskill", "(printf \"Mission Accomplished\")",
     "(set (mission_status Unknown))", "PS0501", "(mission_status Unknown)"},
    {"drone/drone.proskill", "drone.proskill", "  :start (mission_status Ongoing)\n", "", "PS0501",
     "(mission_status "},
    {"rover/rover.proskill", "world.proskill", "(Turning Stuck) ", "", "PS0501", "(wheels Stuck)"},
    {"rover/rover.proskill", "skills.proskill", "powered (>= energy 1)", "awake (>= energy 0)",
     "PS0505", "(energy (- energy 1))"},
    {"arm/arm.proskill", "cell.proskill", "(+ on_table 1)", "(+ on_table 3)", "PS0504",
     "(on_table (+ on_table 3))"},
    // What is never reached, or never used.
    {"drone/drone.proskill", "drone.proskill", "(printf \"Mission failed\")\n",
     "(failure mission_failed)\n(printf \"Mission failed\")\n", "PS0601",
     "(printf \"Mission failed\")"},
    {"lift/lift.proskill", "building.proskill", ":success switched_off",
     ":success switched_off\n  :failure broken", "PS0602", "broken"},
    {"drone/drone.proskill", "drone.proskill", "(NotFound Found)", "(NotFound Found Blurred)",
     "PS0603", "Blurred"},
    {"drone/drone.proskill", "drone.proskill", "(defskill shutdown_drone",
     "(defskill hover :action (hover))\n(defskill shutdown_drone", "PS0610", "hover"},
    {"arm/arm.proskill", "cell.proskill", "(defresource joints)",
     "(defresource joints)\n(defresource gripper)", "PS0613", "gripper"},
    // Waits and tests.
    {"drone/drone.proskill", "drone.proskill", "(printf \"Mission Accomplished\")",
     "(^ (mission_status Succeeded))", "PS0701", "(mission_status Succeeded)"},
    {"drone/drone.proskill", "drone.proskill", "(if (= takeoff.status success)",
     "(if (= landing.status failed_inv) (printf \"no\"))\n     (if (= takeoff.status success)",
     "PS0703", "(= landing.status failed_inv)"},
    {"rover/rover.proskill", "mission.proskill", "(set (place Base))",
     "(set (place Base))\n     (if (place Field) (printf \"lost\"))", "PS0703", "(place Field)"},
    {"drone/drone.proskill", "drone.proskill", "(if (= landing.status success)",
     "(if (= shutdown_drone.status failure) (printf \"no\"))\n        (if (= landing.status "
     "success)",
     "PS0707", "shutdown_drone.status"},
    {"drone/drone.proskill", "drone.proskill", "(printf \"Mission Accomplished\")",
     "(if (= shutdown_drone.status failure) (printf \"no\"))", "PS0706", "failure)"},
    // Conditions of skills.
    {"drone/drone.proskill", "drone.proskill", "not_moving (motion Free)",
     "not_moving (and (motion Free) (motion Controlled))", "PS0801", "not_moving"},
    {"drone/drone.proskill", "drone.proskill", "  :start (camera On)\n", "  :start (camera Off)\n",
     "PS0804", "camera_on"},
    {"drone/drone.proskill", "drone.proskill", ":postcondition (flight_status InAir))",
     ":postcondition (motion Controlled))", "PS0806", "(motion Controlled)"},
    {"lift/lift.proskill", "building.proskill", "(Motor Doors)", "", "PS0502", "(cabin Doors)"},
    // Parallelism.
    {"drone/drone.proskill", "drone.proskill", "(printf \"Mission failed\")", "(takeoff.interrupt)",
     "PS0901", "(takeoff.interrupt)"},
    {"arm/arm.proskill", "cell.proskill", "  :start (tower Yellow)",
     "  :resources (joints)\n  :start (tower Yellow)", "PS0904", "(pick)"},
    // Time.
    {"drone/drone.proskill", "drone.proskill", "(^ 2)", "(^ 0)", "PS1005", "(^ 0)"},
    {"lift/lift.proskill", "building.proskill", ":time_interval [0,5]", ":time_interval [0,1]",
     "PS1003", "[0,1]"},
    {"rover/rover.proskill", "mission.proskill", "(^ (wheels Stuck))",
     "(while (wheels Free) (printf \"rolling\"))", "PS1004", "while"},
    // Events, ranges, and what nothing makes or uses.
    {"lift/lift.proskill", "building.proskill", "(defevent key_turned",
     "(defevent key_back :effects (mode Service))\n(defevent key_turned", "PS0503",
     "(mode Service)"},
    {"lift/lift.proskill", "building.proskill", "(defevent key_turned",
     "(defevent next :effects (wanted (+ wanted 1)))\n(defevent key_turned", "PS0506",
     "(wanted (+"},
    {"drone/drone.proskill", "drone.proskill", "(Ongoing Succeeded))",
     "(Ongoing Succeeded) (Failed Succeeded))", "PS0604", "(Failed Succeeded)"},
    {"arm/arm.proskill", "cell.proskill", "(defevent door_opens",
     "(defevent alarm :effects (light Off))\n(defevent door_opens", "PS0611", "alarm"},
    {"drone/drone.proskill", "drone.proskill", "(defevent battery_to_low",
     "(defsv wind :init 0 :min 0 :max 3)\n(defevent battery_to_low", "PS0612", "wind"},
    {"lift/lift.proskill", "building.proskill", "(label wait_for_a_call)",
     "(label wait_for_a_call)\n(label start)", "PS0614", ""},
    {"drone/drone.proskill", "drone.proskill", "$yaw $duration)", "$yaw)", "PS0615", "duration"},
    // Tests, and calls.
    {"arm/arm.proskill", "arm.proskill", "(^ (>= on_table 1))", "(^ (>= on_table 0))", "PS0702",
     "(>= on_table 0)"},
    {"rover/rover.proskill", "mission.proskill", "(set (place Base))",
     "(set (place Base))\n     (if (place Base) (printf \"home\"))", "PS0704", "(place Base)"},
    {"rover/rover.proskill", "mission.proskill", "(set (place Base))",
     "(set (place Base))\n     (while (place Field) (^ 1))", "PS0705", ""},
    {"arm/arm.proskill", "cell.proskill", "(if (/= pick.status success)", "(if (hand Empty)",
     "PS0708", "pick)"},
    {"arm/arm.proskill", "cell.proskill", "(take_picture)\n     (set (light Off))",
     "(set (light Off))\n     (take_picture)", "PS0802", ""},
    {"drone/drone.proskill", "drone.proskill", "(:guard (~ (battery Critical))",
     "(:guard (& (battery Good) (battery Critical))", "PS0803", "battery"},
    {"drone/drone.proskill", "drone.proskill", "(^ 2)", "(^ 2) (set (camera Off))", "PS0805",
     "(camera Off)"},
    {"arm/arm.proskill", "arm.proskill",
     "(^ (zone Free) :effects (zone Taken))\n          (move_part)",
     "(^ (zone Free))\n          (set (zone Taken))\n          (move_part)", "PS0902",
     "(^ (zone Free)"},
    {"arm/arm.proskill", "cell.proskill", "(defskill look",
     "(defskill look\n  :time_interval [0,0.5]", "PS1002", "[0,0.5]"},
    {"lift/lift.proskill", "building.proskill", ":time_interval [0,5]", ":time_interval [10,20]",
     "PS1001", "[10,20]"},
};

class Overlay : public analysis::FileSystem {
public:
  Overlay(fs::path changed, std::string text)
      : changed(std::move(changed)), text(std::move(text)) {}

  std::expected<std::string, std::string> read(const fs::path& path) const override {
    if (canonical(path) == canonical(changed)) return text;
    std::ifstream file(path);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
  fs::path canonical(const fs::path& path) const override { return fs::weakly_canonical(path); }

private:
  fs::path changed;
  std::string text;
};

std::string read(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What is said, as code and the start of the line's text from the place on.
std::vector<std::string> said(const fs::path& root, const fs::path& changed, std::string text) {
  auto program = analysis::load(Overlay(changed, std::move(text)), root);
  std::vector<std::string> all;
  for (const auto& each : analysis::flow::inspect(program)) {
    const std::string& source = program.files[each.location.file].document.text();
    std::size_t begin = each.location.range.begin;
    std::size_t end = std::min(source.find('\n', begin), begin + 40);
    all.push_back(std::string(syntax::info(each.code).id) + " " +
                  source.substr(begin, end - begin));
  }
  std::ranges::sort(all);
  return all;
}

} // namespace

TEST_CASE("A mistake in an example is told once, where it is, and nothing else is told") {
  for (const Seed& seed : kSeeds) {
    fs::path examples = fs::path(PROSKILL_SOURCE_DIR) / "examples";
    fs::path root = examples / seed.root;
    fs::path changed = root.parent_path() / seed.file;
    std::string text = read(changed);
    auto before = said(root, changed, text);
    std::size_t at = text.find(seed.from);
    INFO(seed.file << ": " << seed.from << "  ->  " << seed.to);
    REQUIRE(at != std::string::npos);
    text.replace(at, std::string_view(seed.from).size(), seed.to);
    std::vector<std::string> found;
    std::ranges::set_difference(said(root, changed, text), before, std::back_inserter(found));
    std::string shown;
    for (const std::string& each : found) shown += each + "\n";
    INFO(shown);
    CHECK(found.size() == 1);
    if (found.size() == 1)
      CHECK(found.front().starts_with(std::string(seed.code) + " " + seed.place));
  }
}
