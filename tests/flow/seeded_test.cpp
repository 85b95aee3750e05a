#include "analysis/flow/inspect.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <span>

namespace proskill::test::seeded_test {

namespace {

namespace fs = std::filesystem;

/// An error inserted into an example, and the expected finding: exactly one new finding, at the
/// place that begins with `place`.
struct Seed {
  const char* root; ///< below examples/
  const char* file;
  const char* from; ///< the first occurrence is replaced
  const char* to;
  const char* code;
  const char* place;
  const char* alsoFrom = ""; ///< a second edit of the same file
  const char* alsoTo = "";
};

const Seed kSeeds[] = {
    // Moves.
    {"drone/drone.proskill", "drone.proskill", "(printf \"Mission Accomplished\")",
     "(set (mission_status Unknown))", "PS0501", "(mission_status Unknown)"},
    {"drone/drone.proskill", "drone.proskill", "  :start (mission_status Ongoing)\n", "", "PS0501",
     "(mission_status "},
    {"rover/rover.proskill", "world.proskill", "(Turning Stuck) ", "", "PS0501", "(wheels Stuck)"},
    {"rover/rover.proskill", "skills.proskill", "powered (>= energy 1)", "powered (/= energy 3)",
     "PS0505", "(energy (- energy 1))"},
    {"arm/arm.proskill", "cell.proskill", "(+ on_table 1)", "(+ on_table 3)", "PS0504",
     "(on_table (+ on_table 3))"},
    // Unreachable or unused.
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
    {"rover/rover.proskill", "world.proskill", "(defconst full_charge 4)",
     "(defconst full_charge 4)\n(defconst half_charge 2)", "PS0616", "half_charge"},
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
    {"drone/drone.proskill", "drone.proskill", "(defevent battery_to_good\n",
     "(defevent battery_to_good\n  :guard (and (battery Low) (battery Critical))\n", "PS0807",
     "(and (battery Low)"},
    {"drone/drone.proskill", "drone.proskill", "(defevent battery_to_good\n",
     "(defevent battery_to_good\n  :guard (or (battery Good) (~ (battery Good)))\n", "PS0808",
     "(or (battery Good)"},
    {"drone/drone.proskill", "drone.proskill", "battery_good (battery Good)",
     "battery_good (battery Good)\n charged (~ (battery Low))", "PS0809", "charged (~"},
    {"drone/drone.proskill", "drone.proskill",
     ":invariant (in_control (:guard (motion Controlled))",
     ":invariant (in_control (:guard (motion Controlled)) moving (:guard (~ (motion Free)))",
     "PS0810", "moving (:guard"},
    {"rover/skills.proskill", "skills.proskill", "  :precondition (daylight (sun Up))\n", "",
     "PS0811", "daylight (:guard"},
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
    {"rover/rover.proskill", "mission.proskill", "     (do-until (= send_report",
     "     (while (= energy 0)\n        (charge percent 40))\n     (do-until (= "
     "send_report",
     "PS1007", "while"},
    {"rover/rover.proskill", "mission.proskill",
     "; Runs in parallel with the mission and never ends.",
     "(defskill stop\n  :monitor t\n  :body ((while true\n           (^ (path Blocked))\n          "
     " "
     "(drive_to.interrupt))))",
     "PS1008", "while"},
    // Events, ranges, and unused effects.
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
    {"drone/drone.proskill", "drone.proskill", "(Unknown Ongoing ", "(Lost Unknown Ongoing ",
     "PS0605", "Lost"},
    {"arm/arm.proskill", "cell.proskill", "[0.5,1]", "[0.125,1]", "PS1006", "[0.125,1]"},
    {"arm/arm.proskill", "arm.proskill", "(defskill serve\n",
     "(defresource tray)\n"
     "(defskill fill :resources (tray) :action (fill))\n"
     "(defskill reach :resources (joints) :action (reach))\n"
     "(defskill stack :resources (joints) :body ((fill)))\n"
     "(defskill unstack :resources (tray) :body ((reach)))\n"
     "(defskill serve\n",
     "PS0903", "(reach)", "(success served)", "(// ((stack)) ((unstack)))\n     (success served)"},
    {"rover/rover.proskill", "mission.proskill", "(defskill monitor_wheels",
     "(defskill monitor_slope :monitor t\n"
     "  :body ((^ (wheels Stuck)) (free_wheels) (if (/= free_wheels.status success) (^ 1))))\n"
     "(defskill monitor_wheels",
     "PS0905", "free_wheels))))"},
    // Style, and comments that ignore.
    {"drone/drone.proskill", "drone.proskill", "(defevent battery_to_low",
     "(defevent Battery_to_low", "PS1101", "Battery_to_low"},
    {"arm/arm.proskill", "cell.proskill", ":failure slipped", ":failure (slipped Slipped)",
     "PS1102", "Slipped"},
    {"drone/drone.proskill", "drone.proskill", "(~ (battery Critical))", "(~ (= battery Critical))",
     "PS1103", "(= battery Critical)"},
    {"drone/drone.proskill", "drone.proskill", "InAirUnsafe Lost)", "InAirUnsafe lost)", "PS1104",
     "lost)", "(flight_status Lost)", "(flight_status lost)"},
    {"drone/drone.proskill", "drone.proskill", "(^ 2)", "; proskill-ignore: PS0701\n(^ 2)",
     "PS1201", "PS0701"},
    {"drone/drone.proskill", "drone.proskill", "(^ 2)", "; proskill-ignore: it\n(^ 2)", "PS1202",
     "it"},
};

/// Errors that earlier checks report; the flow analysis does not report their consequences.
const Seed kMistakes[] = {
    {"drone/drone.proskill", "drone.proskill", "(battery Critical))", "(battery Critcal))",
     "PS0203", "Critcal"},
    {"drone/drone.proskill", "drone.proskill", ":init Unknown", ":init Unknwn", "PS0203", "Unknwn"},
    {"drone/drone.proskill", "drone.proskill", "(^ 2)", "(^ two)", "PS0212", "two"},
    {"drone/drone.proskill", "drone.proskill", "(printf \"Mission Accomplished\")",
     "(printf \"Mission %d\")", "PS0330", "Mission %d"},
    {"drone/drone.proskill", "drone.proskill", "status success)", "status succes)", "PS0211",
     "succes"},
    {"rover/rover.proskill", "skills.proskill", "(- energy 1)", "(- enrgy 1)", "PS0202", "enrgy"},
    {"rover/rover.proskill", "mission.proskill", "(set (place Base))", "(set (place Bse))",
     "PS0203", "Bse"},
    // Misspelt definitions: one error, however often they are used.
    {"drone/drone.proskill", "drone.proskill", "(defskill landing", "(defskill lnding", "PS0201",
     "landing"},
    {"drone/drone.proskill", "drone.proskill", "(defsv motion", "(defsv moton", "PS0202", "motion"},
    {"lift/lift.proskill", "building.proskill", "(defevent key_turned", "(defskil key_turned",
     "PS0109", "defskil"},
    {"arm/arm.proskill", "cell.proskill", ":states (Closed Open)", ":states (Closd Open)", "PS0203",
     "Closed"},
    {"rover/rover.proskill", "world.proskill", "(defevent", "(defevnt", "PS0109", "defevnt"},
    {"rover/rover.proskill", "skills.proskill", "(wheels Free)", "(wheels 3)", "PS0302", "3"},
    {"lift/lift.proskill", "building.proskill", "(step)", "(step up 3)", "PS0208", "up"},
    {"lift/lift.proskill", "building.proskill", "(goto ", "(goto no_", "PS0207", "no_wait"},
    {"arm/arm.proskill", "cell.proskill", "(joints power)", "(joints pwer)", "PS0206", "pwer"},
    {"arm/arm.proskill", "cell.proskill", "(failure lost)", "(failure los)", "PS0205", "los"},
    {"arm/arm.proskill", "cell.proskill", "pick.status", "pick.stats", "PS0210", "stats"},
    {"arm/arm.proskill", "cell.proskill", "(place)", "(place speed 1)", "PS0208", "speed"},
    {"arm/arm.proskill", "cell.proskill", ":capacity 2", ":capacity two", "PS0212", "two"},
    {"arm/arm.proskill", "cell.proskill", "(defenvironment", "(defenviroment", "PS0109",
     "defenviroment"},
};

using Texts = std::map<fs::path, std::string>;

class Overlay : public analysis::FileSystem {
public:
  explicit Overlay(const Texts& changed) : changed(changed) {}

  std::expected<std::string, std::string> read(const fs::path& path) const override {
    if (auto found = changed.find(canonical(path)); found != changed.end()) return found->second;
    std::ifstream file(path);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
  fs::path canonical(const fs::path& path) const override { return fs::weakly_canonical(path); }

private:
  const Texts& changed;
};

std::string read(const fs::path& path) { return *Overlay({}).read(path); }

struct Said {
  analysis::Program program;
  std::vector<syntax::Diagnostic> findings;

  Said(const fs::path& root, const Texts& changed)
      : program(analysis::load(Overlay(changed), root)),
        findings(analysis::flow::inspect(program, {.style = true})) {}

  /// The code, and the text from the place to the end of the line.
  [[nodiscard]] std::string words(const syntax::Diagnostic& each) const {
    const std::string& source = program.files[each.location.file].document.text();
    std::size_t begin = each.location.range.begin;
    std::size_t end = std::min(source.find('\n', begin), begin + 40);
    return std::string(syntax::info(each.code).id) + " " + source.substr(begin, end - begin);
  }
  [[nodiscard]] std::multiset<std::string> all() const {
    std::multiset<std::string> result;
    for (const auto& each : findings) result.insert(words(each));
    return result;
  }
  /// The new findings.
  [[nodiscard]] std::vector<syntax::Diagnostic> without(const Said& before) const {
    std::multiset<std::string> known = before.all();
    std::vector<syntax::Diagnostic> left;
    for (const auto& each : findings)
      if (auto same = known.find(words(each)); same != known.end())
        known.erase(same);
      else
        left.push_back(each);
    return left;
  }
};

struct Seeded {
  fs::path root;
  Texts changed;
};

Seeded sow(const Seed& seed) {
  Seeded result{fs::path(PROSKILL_SOURCE_DIR) / "examples" / seed.root, {}};
  const fs::path path = fs::weakly_canonical(result.root.parent_path() / seed.file);
  std::string text = read(path);
  for (const auto& [from, to] :
       {std::pair(seed.from, seed.to), std::pair(seed.alsoFrom, seed.alsoTo)}) {
    std::size_t at = text.find(from);
    INFO(seed.file << ": " << from);
    REQUIRE(at != std::string::npos);
    text.replace(at, std::string_view(from).size(), to);
  }
  result.changed[path] = text;
  return result;
}

Texts applied(const Said& said, Texts texts, const syntax::Fix& fix) {
  const analysis::File& file = said.program.files[fix.location.file];
  std::string text = file.document.text();
  text.replace(fix.location.range.begin, fix.location.range.length(), fix.text);
  texts[fs::weakly_canonical(file.path)] = text;
  return texts;
}

std::string shown(const Said& said, const std::vector<syntax::Diagnostic>& findings) {
  std::string text;
  for (const auto& each : findings) text += said.words(each) + ": " + each.message + "\n";
  return text;
}

bool isOfFlow(const syntax::CodeInfo& info) { return info.id >= "PS0500" && info.id < "PS1300"; }

void expectOneFinding(std::span<const Seed> seeds) {
  for (const Seed& seed : seeds) {
    Seeded seeded = sow(seed);
    Said before(seeded.root, {});
    Said after(seeded.root, seeded.changed);
    auto found = after.without(before);
    INFO(seed.file << ": " << seed.from << "  ->  " << seed.to << "\n" << shown(after, found));
    CHECK(found.size() == 1);
    if (found.size() == 1)
      CHECK(after.words(found.front()).starts_with(std::string(seed.code) + " " + seed.place));
  }
}

} // namespace

TEST_CASE("A mistake in an example is told once, where it is, and nothing else is told") {
  expectOneFinding(kSeeds);
}

TEST_CASE(
    "A mistake of names or types is told once, and the flow is silent about what comes of it") {
  expectOneFinding(kMistakes);
}

TEST_CASE("The edit that comes with a finding fixes it, and nothing else is told for it") {
  std::size_t fixes = 0;
  for (const Seed& seed : kSeeds) {
    Seeded seeded = sow(seed);
    Said before(seeded.root, {});
    Said after(seeded.root, seeded.changed);
    for (const auto& finding : after.without(before))
      for (const syntax::Fix& fix : finding.fixes) {
        Said fixed(seeded.root, applied(after, seeded.changed, fix));
        auto left = fixed.without(before);
        INFO(after.words(finding) << "\n" << fix.title << "\n" << shown(fixed, left));
        CHECK(left.empty());
        ++fixes;
      }
  }
  CHECK(fixes > 12);
}

TEST_CASE("Every check of the flow has a mistake that was made for it") {
  std::set<std::string_view> sown;
  for (const Seed& seed : kSeeds) sown.insert(seed.code);
  for (const syntax::CodeInfo& info : syntax::allCodes()) {
    INFO(info.id << " " << info.message);
    CHECK((!isOfFlow(info) || sown.contains(info.id)));
  }
}

} // namespace proskill::test::seeded_test
