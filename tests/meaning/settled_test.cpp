#include "tests/meaning/agreement.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

/// The engine's verdicts on the program are those of the interpreter, decided all at once and by
/// slices.
void agreeOn(const std::string& program) {
  for (const auto& options : {verify::Options{}, verify::Options{.classesBeforeSlices = 0}}) {
    const auto comparison = meaning::compare({test::Form(program)}, 20'000, options);
    INFO(comparison.refusal.value_or("") << comparison.disagreement.value_or(""));
    CHECK_FALSE(comparison.refusal);
    CHECK_FALSE(comparison.disagreement);
    CHECK_FALSE(comparison.tooLarge);
    CHECK(comparison.questions > 0);
  }
}

} // namespace

TEST_CASE("both meanings let a call that waits for its turn start after an interrupt") {
  agreeOn(R"((defskill x :interrupt () :time_interval [5,5] :action (x))
    (defskill mission :body ((x)))
    (defskill m2 :monitor t :body ((^ 1) (x)))
    (defskill stop :monitor t :body ((^ 2) (x.interrupt)))
    (defenvironment calm :body ())
    (defproperty again (reachable (and (ended stop) (running x)))))");
}

TEST_CASE("both meanings let an action without a time limit last for ever among all runs") {
  for (const std::string event : {"", "(defsv u :states (P) :init P) (defevent e :effects (u P))"})
    agreeOn("(defskill x :action (x)) (defskill m :body ((x)))" + event +
            "(defproperty p (present (ended m) :fair nil))"
            "(defproperty q (leadsto (running x) (ended m) :fair nil))"
            "(defproperty r (ltl (<> (ended m)) :fair nil))"
            "(defproperty s (infinitelyoften (ended m) :fair nil))");
}

TEST_CASE("both meanings take no step of their own after a forbidden move") {
  agreeOn("(defsv v :states (Good Low) :init Good :transitions ()) (defevent e :effects (v Low))"
          "(defproperty p (ltl (F (not (occurs e)))))");
}

TEST_CASE("both meanings arm a monitor again when its precondition has been false") {
  for (const std::string body :
       {"(set (n (+ n 1)))", "(set (n (+ n 1))) (^ [0,2])", "(set (v Low))"})
    agreeOn(R"((defsv v :states (Low High) :init Low) (defsv n :init 0 :min 0 :max 3)
      (defevent up :every [1,2] :effects (v High)) (defevent down :effects (v Low))
      (defskill mission :body ((^ 3)))
      (defskill watch :monitor always :precondition (high (v High)) :interrupt ()
        :time_interval [0,1] :body ()" +
            body + R"())
      (defenvironment some :body ((^ [1,2]) (emit down) (^ [0,1]) (watch.interrupt)))
      (defproperty p (reachable (= n 2)))
      (defproperty q (leadsto (v Low) (called watch) :within [0,0]))
      (defproperty r (infinitelyoften (ended watch))))");
}

TEST_CASE("a formula about a step without an event is not compared where moves are noted") {
  const auto comparison = meaning::compare(
      {test::Form("(defsv n :init 1 :min 1 :max 3) (defevent e :effects (n (+ n 1)))"
                  "(defproperty p (ltl (=> ([] (occurs e)) (n 3))))"
                  "(defproperty q (ltl ([] (=> (n 3) ([] (n 3))))))")},
      20'000, {}, codegen::Edition::Expanded);
  CHECK_FALSE(comparison.disagreement);
  CHECK(comparison.questions == 3); // not `p`
}
