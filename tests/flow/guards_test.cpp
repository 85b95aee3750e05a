#include "tests/flow/told.h"

using namespace proskill::test;

TEST_CASE("guards of events that are never true, or always") {
  expectAllTold({
      {R"((defsv d :states (A B C) :init A)
(defevent e :effects (d B))
(defevent f :guard [[(d C)]] :effects (d A))
(defskill m :body ((^ (d B)))))",
       "PS0807"},
      {R"((defsv d :states (A B) :init A)
(defevent e :guard [[(or (d A) (d B))]] :effects (d B))
(defskill m :body ((^ (d B)))))",
       "PS0808"},
      {R"((defsv d :states (A B) :init A)
(defevent e :guard (d A) :effects (d B))
(defskill m :body ((^ (d B)))))"},
      // the event never makes the move from A, which would be forbidden
      {R"((defsv d :states (A B C) :init A :transitions ((A B) (B C)))
(defevent e :effects (d B) :guard (d A))
(defevent f :guard (d B) :effects (d C))
(defskill m :body ((^ (d C)))))"},
  });
}

TEST_CASE("conditions that add nothing to those before them") {
  expectAllTold({
      {R"((defsv d :states (A B C) :init A)
(defevent e :effects (d B))
(defevent f :effects (d C))
(defskill s :precondition (in_a (d A) [[not_b (/= d B)]]) :action (s))
(defskill m :body ((s))))",
       "PS0809"},
      {R"((defsv d :states (A B C) :init A)
(defevent e :effects (d B))
(defevent f :effects (d C))
(defskill s :precondition (p (d A))
  :invariant (in_a (:guard (d A)) [[both (:guard (or (d B) (not (d B))))]]) :action (s))
(defskill m :body ((s))))",
       "PS0810"},
  });
}

TEST_CASE("a guard that the start may make false") {
  expectAllTold({
      {R"((defsv d :states (A B C) :init A)
(defevent e :effects (d B))
(defevent f :effects (d C))
(defskill s :precondition (not_c (/= d C)) :invariant ([[in_a (:guard (d A))]]) :action (s)))",
       "PS0811"},
      {R"((defsv d :states (A B C) :init A)
(defevent e :effects (d B))
(defevent f :effects (d C))
(defskill s :precondition (not_c (/= d C)) :start (d A) :invariant (in_a (:guard (d A))) :action (s)))"},
      // of a mission the calls are known
      {R"((defsv d :states (A B) :init A)
(defevent e :effects (d B))
(defskill s :invariant (in_a (:guard (d A))) :action (s))
(defskill m :body ((s))))"},
  });
}
