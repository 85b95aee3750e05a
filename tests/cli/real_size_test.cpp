#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <string>

namespace proskill::test::real_size_test {

namespace {

Finished verify(const std::string& file, const std::string& classes = "100000000") {
  return run({PROSKILL_PROGRAM, "verify", "--traces", "none", "--class-limit", classes, file});
}

} // namespace

TEST_CASE("programs of real size are decided") {
  const std::string missions = PROSKILL_SOURCE_DIR "/bench/missions/";
  for (const auto* name : {"ocean_glider", "orchard_sprayer", "wall_printer"}) {
    INFO(name);
    const Finished done = verify(missions + name + ".proskill");
    CHECK(done.exitCode == 1); // each has a property that is violated
    CHECK(done.out.find("inconclusive") == std::string::npos);
    CHECK(done.out.find(" properties: ") != std::string::npos);
  }
}

TEST_CASE("many skills that nothing connects are decided") {
  std::string text;
  for (int i = 0; i < 40; ++i)
    text += "(defskill s" + std::to_string(i) +
            " :time_interval [1,5] :action (a) :success ok :failure bad)\n";
  const TemporaryDirectory files;
  const Finished done = verify(files.write("many.proskill", text));
  CHECK(done.exitCode == 0);
  CHECK(done.out.find("inconclusive") == std::string::npos);
}

TEST_CASE("a mission of a day is decided beside events and monitors") {
  // 86,000 steps lead to its end
  const TemporaryDirectory files;
  const auto path = files.write(
      "day.proskill", "(defsv door :states (Closed Open) :init Closed)\n"
                      "(defevent opens :effects (door Open))\n"
                      "(defevent closes :effects (door Closed))\n"
                      "(defskill report :time_interval [1,5] :action (r) :interrupt ())\n"
                      "(defskill watch :monitor always :precondition (open (door Open))\n"
                      "  :interrupt () :body ((report) (^ 30)))\n"
                      "(defskill patrol :time_interval [2,3] :action (p))\n"
                      "(defskill day :body ((race ((^ 86400)) ((while true (patrol))))))\n");
  const Finished found = verify(path, "1000000");
  CHECK(found.exitCode == 0);
  CHECK(found.out.find("inconclusive") == std::string::npos);
}

TEST_CASE("a mission of a day is decided where its loops call what others may stop") {
  // where the loops are when the day ends, only a run of the whole program says
  const TemporaryDirectory files;
  const auto path = files.write(
      "day.proskill",
      "(defsv battery :states (Full Low) :init Full :transitions :all)\n"
      "(defsv stop :states (Free Pressed) :init Free :transitions :all)\n"
      "(defevent battery_low :guard (battery Full) :effects (battery Low))\n"
      "(defevent pressed :effects (stop Pressed))\n"
      "(defevent freed :effects (stop Free))\n"
      "(defskill drive :precondition (free (stop Free)) :invariant (safe (:guard (stop Free)))\n"
      "  :time_interval [20,40] :action (d) :success there :failure lost :interrupt ())\n"
      "(defskill charge :time_interval [600,1200] :action (c)\n"
      "  :success (full (:effects (battery Full))))\n"
      "(defskill look :time_interval [5,10] :action (l) :success seen :failure blind)\n"
      "(defskill alarm :monitor always :precondition (p (stop Pressed)) :interrupt ()\n"
      "  :body ((look) (^ 60)))\n"
      "(defskill day :success done\n"
      "  :body ((race ((^ 86400)) ((while true (drive) (look) (^ 1800)))\n"
      "               ((while true (^ (battery Low)) (^ 5) (charge))))\n"
      "         (success done)))\n");
  const Finished found = verify(path, "500000");
  CHECK(found.out.find("can succeed with `done`: reachable") != std::string::npos);
  CHECK(found.out.find("inconclusive") == std::string::npos);
}

TEST_CASE("a mission of three shifts is never late") {
  const TemporaryDirectory files;
  const auto path = files.write(
      "shifts.proskill",
      "(defsv stop :states (Free Pressed) :init Free :transitions :all)\n"
      "(defsv door :states (Closed Open) :init Closed :transitions :all)\n"
      "(defevent opens :effects (door Open))\n"
      "(defevent closes :effects (door Closed))\n"
      "(defevent pressed :effects (stop Pressed))\n"
      "(defevent freed :effects (stop Free))\n"
      "(defskill drive :precondition (free (stop Free)) :invariant (safe (:guard (stop Free)))\n"
      "  :time_interval [20,40] :action (d) :success there :failure lost :interrupt ())\n"
      "(defskill look :time_interval [5,10] :action (l) :success seen :failure blind)\n"
      "(defskill charge :precondition (shut (door Closed)) :time_interval [600,1200] :action (c))\n"
      "(defskill alarm :monitor always :precondition (p (stop Pressed)) :interrupt ()\n"
      "  :body ((look) (^ 60)))\n"
      "(defskill shift :success done\n"
      "  :body ((race ((^ 28800)) ((while true (drive) (look) (^ 120)))) (charge) (success "
      "done)))\n"
      "(defskill mission :success done :failure late\n"
      "  :body ((race ((^ 100000) (failure late)) ((shift) (shift) (shift))) (success done)))\n");
  const Finished found = run({PROSKILL_PROGRAM, "verify", "--property", "mission.can_fail.late",
                              "--class-limit", "2000000", path});
  CHECK(found.out.find("can fail with `late`: unreachable") != std::string::npos);
}

} // namespace proskill::test::real_size_test
