#include "tests/codegen/model_of.h"

#include <catch2/catch.hpp>

namespace proskill::test::race_test {

using codegen::Edition;

namespace {

/// The answers of both editions for verification.
std::map<std::string, std::string> verdicts(const std::string& text) {
  auto compact = test::verdictsOf(text);
  CHECK(test::verdictsOf(text, {.edition = Edition::Expanded}) == compact);
  return compact;
}

} // namespace

TEST_CASE("the first branch of a race to end stops the others, which do nothing more") {
  const auto model = test::modelOf(R"((defsv n :init 0 :min 0 :max 2)
    (defskill mission :body ((race ((set (n 1))) ((^ 5) (set (n 2)))))))");
  CHECK(test::printedState(model, "skill_branch_mission_1_0", "NS2") == R"(from NS2
    if (not skill[mission_branch_1_0].stop) then
        wait [0,0];
        skill[mission_branch_1_1].stop := not (skill[mission_branch_1_1].caller = None);
        skill[mission_branch_1_0].stop := false;
        skill[mission_branch_1_0].caller := None;
        to idle
    else
        wait [0,0];
        on skill[mission_branch_1_0].stop;
        to stopping
    end
)");
}

TEST_CASE("a race gives a call a time limit") {
  const auto found = verdicts(R"(
    (defskill drive :time_interval [1,...[ :action (go))
    (defskill mission :time_interval [1,5] :success (there late)
      :body ((race ((drive) (success there)) ((^ 5))) (success late))))");
  CHECK(found.at("mission.can_succeed.there") == "reachable");
  CHECK(found.at("mission.can_succeed.late") == "reachable");
  CHECK(found.at("mission.no_overshoot") == "holds");
  CHECK(found.at("mission.no_undershoot") == "holds");
}

TEST_CASE("what a race has stopped tells the body that goes on that it was interrupted") {
  const std::string program = R"(
    (defskill drive :time_interval [10,10] :action (go))
    (defskill mission :success (told) :failure (not_told)
      :body ((race ((drive)) ((^ 5)))
             (if (= drive.status interrupted) (success told))
             (failure not_told))))";
  CHECK(verdicts(program).at("mission.can_fail.not_told") == "unreachable");
  // A concurrent call by another skill makes no difference.
  const auto shared = verdicts(program + R"(
    (defskill watch :monitor t :body ((^ 4) (drive) (drive))))");
  CHECK(shared.at("mission.can_fail.not_told") == "unreachable");
  CHECK(shared.at("mission.can_succeed.told") == "reachable");
}

TEST_CASE("who would have ended later does not end the skill") {
  const auto later = verdicts(R"((defskill mission :failure (lost)
    :body ((race ((^ 1)) ((^ 2) (failure lost))))))");
  CHECK(later.at("mission.can_fail.lost") == "unreachable");
  const auto same = verdicts(R"((defskill mission :failure (lost)
    :body ((race ((^ 1)) ((^ 1) (failure lost))))))");
  CHECK(same.at("mission.can_fail.lost") == "reachable");
  CHECK(same.at("mission.can_succeed") == "reachable");
}

TEST_CASE("a race waits for what must not be stopped") {
  const auto found = verdicts(R"(
    (defskill brake :interruptible nil :time_interval [3,4] :action (brake))
    (defskill mission :time_interval [3,4] :failure (early)
      :body ((race ((brake)) ((^ 1))) (if (/= brake.status success) (failure early)))))");
  CHECK(found.at("mission.no_undershoot") == "holds");
  CHECK(found.at("mission.no_overshoot") == "holds");
  CHECK(found.at("mission.can_fail.early") == "unreachable");
}

TEST_CASE("races within races and within loops stop all that is within them") {
  const auto found = verdicts(R"(
    (defsv rounds :init 0 :min 0 :max 3)
    (defskill drive :time_interval [2,9] :action (go))
    (defskill turn :time_interval [2,9] :action (turn))
    (defskill mission :time_interval [3,3]
      :body ((while (< rounds 3)
               (race ((race ((// ((drive)) ((turn)))) ((^ 5)))) ((^ 1)))
               (label idle)
               (set (rounds (+ rounds 1))))))
    (defproperty stopped (never (and (at idle) (or (running drive) (running turn))))))");
  CHECK(found.at("stopped") == "holds");
  CHECK(found.at("mission.no_undershoot") == "holds");
  CHECK(found.at("mission.no_overshoot") == "holds");
}

} // namespace proskill::test::race_test
