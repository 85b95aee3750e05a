#include "tests/bridge/random_mission.h"

#include "tests/support/random/random_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace proskill::test {
namespace {

using Skills = std::vector<std::string>;

class MissionWriter {
public:
  explicit MissionWriter(std::uint64_t seed)
      : random(seed), hasTimes(seed % 2 == 0), isRefusing(seed % 8 < 2), isGuarded(seed % 3 == 0) {}

  std::string program() {
    std::string text;
    for (int i = 0; i < 3; ++i)
      text += fmt::format("(defsv c{0} :states (Yes No) :init Yes)\n"
                          "(defevent c{0}_on :effects (c{0} Yes))\n"
                          "(defevent c{0}_off :effects (c{0} No))\n",
                          i);
    for (int i = 0; i < 5; ++i)
      text += fmt::format("(defskill a{}{} :action (go) :success ok{})\n", i,
                          i == 4 && isRefusing ? " :precondition (on (c0 Yes))" : "",
                          i < 3 ? " :failure bad" : "");
    if (isGuarded)
      text += "(defsv calm :states (Yes No) :init Yes)\n"
              "(defevent calms :effects (calm Yes))\n"
              "(defevent storms :effects (calm No))\n";
    text += skill("part", {"a0", "a1"});
    return text + skill("Main", {"a1", "a2", "a3", "a4", "part"});
  }

private:
  std::string skill(const std::string& name, const Skills& skills) {
    const auto body = block(skills, name == "Main" ? 3 : 1, true);
    const auto guard = isGuarded && name == "part" ? " :invariant (on (:guard (calm Yes)))" : "";
    return fmt::format("(defskill {} :success ok :failure bad{}\n :body ({}))\n", name, guard,
                       body);
  }

  std::string block(const Skills& skills, int depth, bool mayLeave) {
    std::string text;
    for (std::size_t i = 1 + random.below(3); i > 0; --i) text += statement(skills, depth);
    if (mayLeave && random.chance(40)) text += random.chance(50) ? "(success ok)" : "(failure bad)";
    return text;
  }

  std::string condition() {
    const auto test = fmt::format("(c{} {})", random.below(3), random.chance(60) ? "Yes" : "No");
    if (random.chance(15)) return "(not " + test + ")";
    if (random.chance(15)) return "(and (c0 Yes) (or (c1 No) (c2 Yes)))";
    return test;
  }

  std::string statement(const Skills& skills, int depth) {
    if (skills.empty()) return random.chance(50) ? pause() : fmt::format("(^ {})", condition());
    if (depth == 0 || ++count > 8 || random.chance(40)) return simple(skills, depth);
    switch (random.below(6)) {
    case 0:
      return fmt::format("(if {} {} {})\n", condition(), block(skills, depth - 1, true),
                         random.chance(50) ? "else " + block(skills, depth - 1, true) : "");
    case 1:
      return fmt::format("(while {} {} {})\n", condition(), call(skills),
                         random.chance(30) ? "(if (c0 No) break)" : "");
    case 2: return fmt::format("(do {} until {})\n", block(skills, depth - 1, false), condition());
    case 3: return retry(skills);
    default: return branches(skills, depth);
    }
  }

  std::string simple(const Skills& skills, int depth) {
    switch (random.below(6)) {
    case 0: return fmt::format("(^ {})", condition());
    case 1: return pause();
    case 2: {
      const auto name = random.pick(skills);
      const auto part = depth == 0 ? leave() : block(skills, depth - 1, true);
      return fmt::format("({0}) (if (= {0}.status {1}) {2})\n", name,
                         random.chance(50) ? "success" : "failure", part);
    }
    case 3: {
      const auto name = random.pick(skills);
      return fmt::format("(case ({}) ((success) {}) ((failure) {}) (else))\n", name, leave(),
                         leave());
    }
    default: return call(skills);
    }
  }

  std::string leave() {
    return random.pick<std::string>({"", "", "(success ok)", "(failure bad)", pause()});
  }

  std::string pause() { return hasTimes ? "(^ 1)" : "(^ (c2 Yes))"; }

  std::string call(const Skills& skills) { return fmt::format("({})\n", random.pick(skills)); }

  std::string retry(const Skills& skills) {
    const auto name = random.pick(skills);
    const auto label = fmt::format("l{}", labels++);
    return fmt::format("(label {0}) ({1}) (if (/= {1}.status success) {2} (goto {0}))\n", label,
                       name, random.chance(50) ? pause() : "");
  }

  /// A skill is called in one branch only.
  std::string branches(const Skills& skills, int depth) {
    Skills left;
    Skills right;
    for (const auto& name : skills) (random.chance(50) ? left : right).push_back(name);
    std::erase(right, "part"); // it calls what others call
    if (std::ranges::find(left, "part") != left.end()) std::erase(right, "a1");
    const bool mayLeave = random.chance(50);
    return fmt::format("({} ({}) ({}))\n", random.chance(50) ? "//" : "race",
                       block(left, depth - 1, mayLeave), block(right, depth - 1, mayLeave));
  }

  RandomSource random;
  bool hasTimes;
  bool isRefusing; ///< whether the call of a4 may be refused
  bool isGuarded;  ///< whether `part` has a guard
  int count = 0;
  int labels = 0;
};

} // namespace

std::string randomMission(std::uint64_t seed) { return MissionWriter(seed).program(); }

} // namespace proskill::test
