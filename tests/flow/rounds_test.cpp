#include "analysis/flow/inspect.h"
#include "syntax/diagnostics/codes.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

namespace proskill::test::rounds_test {

namespace {

/// The findings of a program, without hints of style.
std::string codes(const std::string& program) {
  std::string all;
  for (const auto& it : analysis::flow::inspect(test::programOfText(program), {}))
    all += syntax::info(it.code).id;
  return all;
}

} // namespace

TEST_CASE("what a body reads before its own call is of no other body's call") {
  // `last` has no outcome of its own yet, so its wait ends at once: no finding.
  const std::string program = "(defskill s :action (s) :failure bad)\n"
                              "(defskill first :body ((s) (^ (= s.status failure))))\n"
                              "(defskill last :body ((^ (/= s.status failure)) (s)))\n"
                              "(defskill m :body ((first) (last)))";
  CHECK(codes(program).find("PS0701") == std::string::npos);
}

TEST_CASE(
    "what a body reads is of its own call, whatever something that it calls has called since") {
  const std::string parts =
      "(defskill s :time_interval [1,1] :action (s) :success ok :failure bad)\n"
      "(defskill c :success done :body ((do (s) until (= s.status success)) (success done)))\n";
  const auto told = [&](const std::string& body) {
    return codes(parts + "(defskill m :success done :failure no :body (" + body + "))");
  };
  // only `c` can know how its own calls have ended
  CHECK(told("(s) (c) (if (/= s.status success) (failure no)) (success done)").empty());
  CHECK(
      told("(s) (// ((c)) ((^ 1))) (if (= s.status success) (success done)) (failure no)").empty());
  CHECK(told("(c) (if (/= s.status success) (failure no)) (success done)") == "PS0703");
  // a guard reads the last call by anybody
  CHECK(codes(parts + "(defskill m :invariant (i (:guard (/= s.status failure))) :success done "
                      ":body ((s) (if (= s.status success) (c)) (success done)))")
            .empty());
}

TEST_CASE("A loop that a refused call keeps going is told at its beginning") {
  const std::string door = "(defsv door :states (Closed Open) :init Closed)\n"
                           "(defevent opens :effects (door Open))\n"
                           "(defskill drive :precondition (clear (door Open)) "
                           ":time_interval [1,2] :action (d) :success ok :failure ko)\n";
  const auto told = [&](const std::string& body) {
    return codes(door + "(defskill m :body (" + body + "))");
  };
  CHECK(told("(while (/= drive.status success) (drive))") == "PS1007");
  CHECK(told("(do (drive) until (= drive.status success))") == "PS1007");
  CHECK(told("(label again) (drive) (if (= drive.status no_status) (goto again))") == "PS1007");
  // it waits, tests before it calls, or leaves after a refusal
  CHECK(told("(while (/= drive.status success) (drive) (^ 1))").empty());
  CHECK(told("(while true (^ (door Open)) (drive) (if (= drive.status failure) break))").empty());
  CHECK(told("(while true (if (door Open) (drive)) (if (= drive.status failure) break) (^ 1))")
            .empty());
  CHECK(told("(while true (drive) (if (/= drive.status success) break))").empty());
}

TEST_CASE("A loop is told whose call runs a body in which a call is refused") {
  const std::string door = "(defsv door :states (Closed Open) :init Closed)\n"
                           "(defsv tries :init 0 :min 0 :max 3)\n"
                           "(defevent opens :effects (door Open))\n"
                           "(defskill drive :precondition (clear (door Open)) "
                           ":time_interval [1,2] :action (d) :success ok :failure ko)\n";
  const auto told = [&](const std::string& part, const std::string& body) {
    return codes(door + "(defskill c :success done :failure no :body (" + part +
                 "))(defskill m :body (" + body + "))")
        .contains("PS1007");
  };
  const std::string fails = "(drive) (if (= drive.status success) (success done)) (failure no)";
  CHECK(told(fails, "(while (/= c.status success) (c))"));
  CHECK(told(fails, "(do (c) until (= c.status success))"));
  CHECK(told("(case (drive) (success (success done)) (failure) (refused (failure no))) (^ 1)",
             "(while (/= c.status success) (c))"));
  // the body waits, counts, or tests before it calls; or the loop waits or ends
  CHECK_FALSE(told("(drive) (if (= drive.status success) (success done)) (^ 1) (failure no)",
                   "(while (/= c.status success) (c))"));
  CHECK_FALSE(told("(drive) (if (= drive.status success) (success done)) (set (tries (+ tries 1))) "
                   "(failure no)",
                   "(while (and (/= c.status success) (< tries 3)) (c))"));
  CHECK_FALSE(
      told("(^ (door Open)) (drive) (if (= drive.status success) (success done)) (failure no)",
           "(while (/= c.status success) (c))"));
  CHECK_FALSE(told(fails, "(while (/= c.status success) (c) (^ 1))"));
  CHECK_FALSE(told(fails, "(while true (c) (if (= c.status failure) break))"));
}

TEST_CASE("A body that somebody may interrupt or hold up does not keep a loop going") {
  const std::string parts =
      "(defsv door :states (Closed Open) :init Closed)\n"
      "(defevent opens :effects (door Open))\n"
      "(defresource arm)\n"
      "(defskill drive :precondition (clear (door Open)) :time_interval [1,2] :action (d))\n"
      "(defskill grip :resources (arm) :time_interval [1,2] :action (g))\n"
      "(defskill c :interrupt () :resources (arm) :success done :failure no\n"
      "  :body ((drive) (if (= drive.status success) (success done)) (failure no)))\n";
  const auto told = [&](const std::string& rest) { return codes(parts + rest).contains("PS1007"); };
  const std::string loop = "(while (/= c.status success) (c))";
  CHECK(told("(defskill m :body ((grip) " + loop + "))"));
  CHECK_FALSE(
      told("(defskill m :body (" + loop + "))(defskill w :monitor t :body ((^ 1) (grip)))"));
  CHECK_FALSE(
      told("(defskill m :body (" + loop + "))(defskill w :monitor t :body ((^ 1) (c.interrupt)))"));
}

TEST_CASE("A precondition on the skill's own status sees it reset by the call") {
  const std::string once = "(defskill s :precondition (p (= s.status no_status)) :action (a))";
  CHECK(codes(once + "(defskill m :body ((s) (s)))").empty());
  CHECK(codes("(defskill s :precondition (p (= s.status success)) :action (a))"
              "(defskill m :body ((s) (s)))")
            .starts_with("PS0802"));
}

TEST_CASE("A refused call that skills beside rule out is not told") {
  const std::string others = "(defsv cabin :states (Idle Doors Motor) :init Idle)\n"
                             "(defsv doors :states (Closed Open) :init Closed)\n"
                             "(defskill go :precondition (closed (doors Closed)) "
                             ":time_interval [1,2] :action (g))\n"
                             "(defskill m :body ((^ (cabin Idle) :effects (cabin Motor)) "
                             "(while (/= go.status success) (go)) (set (cabin Idle))))\n"
                             "(defskill w :monitor t :body ((^ 1) (^ (cabin Idle) :effects (cabin "
                             "Doors)) (set (doors Open)) (set (doors Closed)) (set (cabin Idle))))";
  CHECK(codes(others).empty());
}

TEST_CASE("A loop that others may end at once is not told") {
  const std::string start = R"((defsv door :states (Closed Open) :init Open)
    (defevent opens :effects (door Open)) (defevent closes :effects (door Closed))
    (defskill drive :precondition (clear (door Open)) :time_interval [1,2] :action (d)
      :success ok :failure ko)
    (defskill other :time_interval [1,2] :action (o))
    )";
  const std::string loop = "(while (/= drive.status success) (drive))";
  const std::string guarded = "(defskill m :invariant (i (:guard (door Open))) :body ";
  const std::string called = "(defskill x :body (" + loop + "))\n";
  const auto isTold = [&](const std::string& rest) {
    return codes(start + rest).find("PS1007") != std::string::npos;
  };
  CHECK_FALSE(isTold(guarded + "((// (" + loop + ") ((other)))))"));
  CHECK_FALSE(isTold(called + guarded + "((x)))"));
  CHECK_FALSE(isTold("(defskill m :failure f :body ((// (" + loop +
                     ") ((^ (door Closed)) (failure f)))))"));
  CHECK_FALSE(isTold("(defskill x :interrupt () :body (" + loop + "))\n" +
                     "(defskill m :body ((// ((x)) ((^ (door Closed)) (x.interrupt)))))"));
  CHECK(isTold(called + "(defskill m :body ((// ((x)) ((other)))))"));
}

TEST_CASE("A loop whose wait does not wait again is told at its beginning") {
  const auto told = [](const std::string& body) {
    return codes("(defsv battery :states (Good Critical) :init Good)\n"
                 "(defevent goes_critical :effects (battery Critical))\n"
                 "(defevent charged :effects (battery Good))\n"
                 "(defskill a :time_interval [1,2] :action (a) :interrupt ())\n"
                 "(defskill m :body ((a) (a)))\n"
                 "(defskill w :monitor t :body (" +
                 body + "))");
  };
  CHECK(told("(while true (^ (battery Critical)) (a.interrupt))") == "PS1008");
  CHECK(told("(while true (^ (battery Critical)) (a.interrupt) (^ (battery Good)))").empty());
  CHECK(told("(while true (^ (battery Critical)) (a.interrupt) (^ 1))").empty());
  CHECK(told("(while true (^ (battery Critical) :effects (battery Good)) (a.interrupt))").empty());
}

TEST_CASE("A wait that events with a period may not come to in time is not told") {
  const auto told = [](const std::string& event, const std::string& body) {
    return codes("(defsv v :states (Low Bad) :init Bad)\n"
                 "(defevent recovered " +
                 event + " :effects (v Low))\n(defskill m :body (" + body + "))");
  };
  const std::string timed = ":every ]1,3]";
  // the loop is left at once, before the event
  CHECK(told(timed, "(do-until (v Bad) (^ true))").find("PS1008") == std::string::npos);
  CHECK(told("", "(do-until (v Bad) (^ true))").find("PS1008") != std::string::npos);
  // it is awaited, however long it takes
  CHECK(told(timed, "(while true (^ (v Low)) (printf \"low\"))").find("PS1008") !=
        std::string::npos);
  CHECK(told(timed, "(while true (^ (v Low) :timeout 1) (if (v Bad) break))").find("PS1008") ==
        std::string::npos);
}

} // namespace proskill::test::rounds_test
