#include "tests/embed/embedded.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace proskill;
using Catch::Contains;
using test::Embedded;

namespace {

const std::string kOneFlight = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill fly :action (fly) :interrupt () :success there)
  (defskill mission :success done :body ((fly) (success done))))";

/// The text of an error with this code.
std::string textOf(proskill_error code, proskill_error expected) {
  CHECK(code == expected);
  return proskill_error_text();
}

std::string optionsError(const proskill_options& options) {
  const Embedded run(kOneFlight);
  proskill_executor* made = nullptr;
  const auto text =
      textOf(proskill_executor_new(run.program, &options, &made), PROSKILL_INVALID_ARGUMENT);
  CHECK(made == nullptr);
  return text;
}

} // namespace

TEST_CASE("a file that cannot be read is an error with its name") {
  proskill_program* program = nullptr;
  CHECK_THAT(
      textOf(proskill_program_load("/nowhere/mission.proskill", &program), PROSKILL_UNREADABLE),
      Contains("cannot read `/nowhere/mission.proskill`"));
}

TEST_CASE("errors of a program have their places") {
  CHECK(test::loadError("(defevent storm :effects (sky Stormy))", PROSKILL_INVALID_PROGRAM) ==
        "mission.proskill:1:27: error: unknown state variable `sky` [PS0202]");
}

TEST_CASE("names are checked, with suggestions") {
  Embedded run(kOneFlight);
  CHECK_THAT(textOf(run.performBy("flyy", [](auto...) {}), PROSKILL_UNKNOWN_NAME),
             Contains("there is no basic skill `flyy`; did you mean `fly`?"));
  run.perform("fly", {1, "there"});
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  CHECK(textOf(proskill_executor_report(run.executor, "strom"), PROSKILL_UNKNOWN_NAME) ==
        "there is no event `strom`; did you mean `storm`?");
  CHECK(textOf(proskill_executor_interrupt(run.executor, "storm"), PROSKILL_UNKNOWN_NAME) ==
        "there is no skill with `:interrupt` `storm`");
  const char* value = nullptr;
  CHECK(textOf(proskill_executor_value(run.executor, "sxy", &value), PROSKILL_UNKNOWN_NAME) ==
        "there is no value `sxy`; did you mean `sky`?");
  CHECK(textOf(proskill_executor_finish(run.executor, 99, "there"), PROSKILL_INVALID_ARGUMENT) ==
        "no action has run 99");
}

TEST_CASE("a run does not start while an action is missing") {
  Embedded run(kOneFlight);
  CHECK(textOf(proskill_executor_run(run.executor), PROSKILL_MISSING_ACTION) ==
        "nobody performs the action of `fly`");
  run.perform("fly", {1, "there"});
  CHECK(proskill_executor_run(run.executor) == PROSKILL_OK);
}

TEST_CASE("calls in a wrong order are errors") {
  Embedded run(kOneFlight);
  const std::string early = "the run has not started";
  const char* value = nullptr;
  CHECK(textOf(proskill_executor_proceed(run.executor), PROSKILL_WRONG_ORDER) == early);
  CHECK(textOf(proskill_executor_report(run.executor, "storm"), PROSKILL_WRONG_ORDER) == early);
  CHECK(textOf(proskill_executor_value(run.executor, "sky", &value), PROSKILL_WRONG_ORDER) ==
        early);
  CHECK(textOf(proskill_executor_finish(run.executor, 1, "there"), PROSKILL_WRONG_ORDER) == early);
  run.perform("fly", {1, "there"});
  REQUIRE(proskill_executor_start(run.executor) == PROSKILL_OK);
  const std::string late = "the run has already started";
  CHECK(textOf(proskill_executor_start(run.executor), PROSKILL_WRONG_ORDER) == late);
  CHECK(textOf(run.performBy("fly", [](auto...) {}), PROSKILL_WRONG_ORDER) == late);
  CHECK(textOf(proskill_executor_observe(run.executor, nullptr, nullptr), PROSKILL_WRONG_ORDER) ==
        late);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(textOf(proskill_executor_proceed(run.executor), PROSKILL_WRONG_ORDER) ==
        "the run has ended");
  CHECK(textOf(proskill_executor_run(run.executor), PROSKILL_WRONG_ORDER) == "the run has ended");
  CHECK(proskill_executor_report(run.executor, "storm") == PROSKILL_OK); // nobody hears it
}

TEST_CASE("what the executor calls must not call it, nor free it") {
  Embedded run(kOneFlight);
  const auto begin = [](proskill_executor* in, proskill_run start, const proskill_value*, size_t,
                        void*) {
    CHECK_THAT(textOf(proskill_executor_proceed(in), PROSKILL_WRONG_ORDER), Contains("is in use"));
    CHECK_THAT(textOf(proskill_executor_run(in), PROSKILL_WRONG_ORDER), Contains("is in use"));
    CHECK_THAT(textOf(proskill_executor_free(in), PROSKILL_WRONG_ORDER), Contains("is in use"));
    const char* value = nullptr;
    CHECK(proskill_executor_value(in, "sky", &value) == PROSKILL_OK);
    proskill_executor_finish(in, start, "there");
  };
  REQUIRE(run.performBy("fly", begin) == PROSKILL_OK);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(std::string(proskill_executor_outcome(run.executor)) == "success");
}

TEST_CASE("an observer that throws ends the call, and the run can go on") {
  Embedded run(kOneFlight);
  run.perform("fly", {1, "there"});
  const auto observer = [](proskill_executor*, const proskill_entry* entry, void*) {
    if (entry->kind == PROSKILL_STARTED) throw std::runtime_error("no paper");
  };
  REQUIRE(proskill_executor_observe(run.executor, observer, nullptr) == PROSKILL_OK);
  CHECK(textOf(proskill_executor_run(run.executor), PROSKILL_SYSTEM_ERROR) ==
        "the observer has thrown: no paper");
  CHECK(proskill_executor_phase(run.executor) == PROSKILL_RUNNING);
  REQUIRE(proskill_executor_run(run.executor) == PROSKILL_OK);
  CHECK(std::string(proskill_executor_outcome(run.executor)) == "success");
}

TEST_CASE("options are checked") {
  proskill_options options{};
  CHECK_THAT(optionsError(options), Contains("must begin as PROSKILL_OPTIONS"));
  const proskill_options usual = PROSKILL_OPTIONS;
  options = usual;
  options.speed = 0;
  CHECK_THAT(optionsError(options), Contains("`speed`"));
  options = usual;
  options.until = -1;
  CHECK_THAT(optionsError(options), Contains("`until`"));
  options = usual;
  options.grace = NAN;
  CHECK_THAT(optionsError(options), Contains("`grace`"));
}

TEST_CASE("a mission that is not there is an error of the program") {
  const Embedded run(kOneFlight);
  auto options = Embedded::simulated();
  options.main_skill = "nothing";
  proskill_executor* made = nullptr;
  CHECK_THAT(textOf(proskill_executor_new(run.program, &options, &made), PROSKILL_INVALID_PROGRAM),
             Contains("nothing"));
}

TEST_CASE("null pointers are errors, and nothing to free") {
  proskill_program* program = nullptr;
  CHECK(textOf(proskill_program_load(nullptr, &program), PROSKILL_INVALID_ARGUMENT) ==
        "`file` must not be NULL");
  CHECK(proskill_program_load("mission.proskill", nullptr) == PROSKILL_INVALID_ARGUMENT);
  CHECK(proskill_executor_new(nullptr, nullptr, nullptr) == PROSKILL_INVALID_ARGUMENT);
  CHECK(proskill_executor_start(nullptr) == PROSKILL_INVALID_ARGUMENT);
  CHECK(proskill_executor_report(nullptr, "storm") == PROSKILL_INVALID_ARGUMENT);
  CHECK(proskill_executor_free(nullptr) == PROSKILL_OK);
  proskill_program_free(nullptr);
  proskill_executor_stop(nullptr);
  const Embedded run(kOneFlight);
  CHECK(textOf(proskill_executor_perform(run.executor, "fly", nullptr, nullptr, nullptr),
               PROSKILL_INVALID_ARGUMENT) == "`begin` must not be NULL");
  CHECK(proskill_executor_report(run.executor, nullptr) == PROSKILL_INVALID_ARGUMENT);
}
