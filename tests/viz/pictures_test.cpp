#include "tests/viz/outline.h"

#include <catch2/catch.hpp>

#include <filesystem>

namespace proskill::test::pictures_test {

using namespace proskill::viz;
using namespace proskill::viz::test;

namespace {

/// The outline of a body, in a program with the skills `a` and `b`.
std::string body(const std::string& statements) {
  const auto text = "(defskill a :action (a))\n(defskill b :action (b) :interrupt (:effects ()))\n"
                    "(defsv s :states (X Y) :init X)\n"
                    "(defskill m :body (" +
                    statements + "))";
  return outline(picture(program(text), Kind::Body, "m"));
}

} // namespace

TEST_CASE("a state variable shows the moves that are allowed") {
  const auto p = program("(defsv battery :states (Good Low Critical) :init Good\n"
                         "  :transitions ((Good Low) (Low Critical) (Critical Low)))");
  CHECK(outline(picture(p, Kind::StateVariable, "battery")) == R"(
state Good
state Low
state Critical
start
start -> Good
Good -> Low
Low <-> Critical
)");
}

TEST_CASE("a state variable shows the forbidden moves on request") {
  const auto p = program("(defsv battery :states (Good Low Critical) :init Good\n"
                         "  :transitions ((Good Low) (Low Critical) (Critical Low)))");
  CHECK(outline(picture(p, Kind::StateVariable, "battery", true)) == R"(
state Good
state Low
state Critical
start
start -> Good
Good -> Low
Low -> Good [forbidden]
Good <-> Critical [forbidden]
Low <-> Critical
)");
}

TEST_CASE("where all moves are allowed the picture says so") {
  const auto p = program("(defsv s :states (A B) :init (B A) :transitions :all)");
  const auto graph = picture(p, Kind::StateVariable, "s", true);
  CHECK(graph.note == "every move is allowed");
  CHECK(outline(graph) == R"(
state A
state B
start
start -> B
start -> A
A <-> B
)");
}

TEST_CASE("a natural is one state with its bounds") {
  const auto p = program("(defsv level :init 3 :min 0 :max 5)");
  CHECK(outline(picture(p, Kind::StateVariable, "level", true)) == R"(
state 0 … 5 {every move is allowed}
start
error outside {stays at the bound}
start -> 0 … 5: 3
0 … 5 -> outside [forbidden]
)");
}

TEST_CASE("a basic skill goes from its precondition to its outcomes") {
  const auto p = program(R"((defresource arm)
(defskill pick
  :input ($height float)
  :precondition (free (hand Empty) near (place Table))
  :start (hand Moving)
  :invariant (closed (:guard (door Closed) :effects (hand Stopped)))
  :time_interval [1 , 2]
  :resources (arm)
  :action (pick $height)
  :interrupt (:effects (hand Stopped))
  :success held (:effects (hand Full) :postcondition (grip Firm))
  :failure (slipped (:effects (hand Empty)) lost)))");
  CHECK(outline(picture(p, Kind::Skill, "pick")) == R"(
start
test precondition? {free: (hand Empty); near: (place Table)}
end refused {no_status}
step start {hand := Moving; takes arm}
action run {(pick $height); [1 , 2] s}
end returns
success held {hand := Full; then (grip Firm)}
failure slipped {hand := Empty}
failure lost
invariant closed {fails: (door Closed); hand := Stopped}
interrupt interrupted {hand := Stopped}
start -> precondition?
precondition? -> refused [no]: no
precondition? -> start [yes]: yes
start -> run
run -> held
held -> returns
run -> slipped
slipped -> returns
run -> lost
lost -> returns
run -> closed [stops]
closed -> returns
run -> interrupted [stops]
interrupted -> returns
)");
}

TEST_CASE("a body is its statements in a row") {
  CHECK(body(R"((a x 1 y "two") (^ (s Y) :effects (s X)) (^ [1,3]) (b.interrupt)
               (set ((s Y))) (printf "hi %d" s))") == R"(
start
call a {x 1 y "two"}
wait until (s Y) {s := X}
wait wait [1,3] s
interrupt interrupt b
step set {s := Y}
message “hi %d”
success success {end of the body}
start -> a
a -> until (s Y)
until (s Y) -> wait [1,3] s
wait [1,3] s -> interrupt b
interrupt b -> set
set -> “hi %d”
“hi %d” -> success
)");
}

TEST_CASE("tests branch, and what follows them joins") {
  CHECK(body("(if (s X) (a) elseif (s Y) (b) else (^ 1)) (a)") == R"(
start
test (s X)
call a
test (s Y)
call b
wait wait 1 s
call a
success success {end of the body}
start -> (s X)
(s X) -> a [yes]: yes
(s X) -> (s Y) [no]: no
(s Y) -> b [yes]: yes
(s Y) -> wait 1 s [no]: no
a -> a
b -> a
wait 1 s -> a
a -> success
)");
}

TEST_CASE("a case goes from its call to an arm for each outcome") {
  const auto drawn = body("(case (a) (success (b)) ((failure lost)) (else (^ 1))) (printf \"x\")");
  for (const auto* edge : {"a -> b: success", "a -> “x”: (failure lost)", "a -> wait 1 s: else"})
    CHECK(drawn.contains(edge));
}

TEST_CASE("a wait with a timeout has a second way on") {
  CHECK(body("(^ (s X) :timeout 5 (a))").contains("until (s X) -> a: after 5 s"));
}

TEST_CASE("what must not be stopped says so") {
  const auto p = program("(defskill put :interruptible nil :action (put))");
  CHECK(outline(picture(p, Kind::Skill, "put")).contains("action run {(put); is never stopped}"));
}

TEST_CASE("loops go back, and break leaves them") {
  CHECK(body("(while (s X) (a) (if (s Y) break))") == R"(
start
test (s X)
call a
test (s Y)
success success {end of the body}
start -> (s X)
(s X) -> a [yes]: yes
a -> (s Y)
(s Y) -> (s X) [no]: no
(s Y) -> success [yes]: yes
(s X) -> success [no]: no
)");
  CHECK(body("(do (a) until (s Y))") == R"(
start
junction
call a
test (s Y)
success success {end of the body}
start -> junction
junction -> a
a -> (s Y)
(s Y) -> junction [no]: no
(s Y) -> success [yes]: yes
)");
}

TEST_CASE("goto goes to its label, forwards and backwards") {
  CHECK(body("(label top) (if (s X) (goto down)) (a) (goto top) (label down)") == R"(
start
label top
test (s X)
call a
label down
success success {end of the body}
start -> top
top -> (s X)
(s X) -> a [no]: no
(s X) -> down [yes]: goto down
a -> top: goto top
down -> success
)");
}

TEST_CASE("branches run from a fork to a join, each in its frame") {
  CHECK(body("(// ((a)) ((b) (^ 2)))") == R"(
start
fork
call a in branch 1
call b in branch 2
wait wait 2 s in branch 2
join
success success {end of the body}
start -> fork
fork -> a
fork -> b
b -> wait 2 s
a -> join
wait 2 s -> join
join -> success
)");
}

TEST_CASE("outcomes end a body with their effects, and a composite is watched") {
  const auto p = program(R"((defskill m
  :time_interval [2,5]
  :invariant (dry (:guard (rain No)))
  :success done (:effects (s Y) :postcondition (t Z))
  :failure broken
  :body ((if (s X) (success done)) (failure broken))))");
  CHECK(outline(picture(p, Kind::Body, "m")) == R"(
start
test (s X)
success done {s := Y; then (t Z)}
failure broken
invariant dry {fails: (rain No)} in at any time
start in watchdog [2,5] s
state early in watchdog [2,5] s
state on time in watchdog [2,5] s
end in time in watchdog [2,5] s
error undershoot in watchdog [2,5] s
error overshoot in watchdog [2,5] s
start -> (s X)
(s X) -> done [yes]: yes
(s X) -> broken [no]: no
start -> early: starts
early -> on time: 2 s
on time -> in time: ends
early -> undershoot [forbidden]: ends
on time -> overshoot [forbidden]: after 5 s
)");
}

TEST_CASE("a watchdog shows the bounds that there are") {
  const auto watchdog = [](const std::string& interval) {
    return outline(
        picture(program("(defskill m :time_interval " + interval + " :body ((success done)))"),
                Kind::Body, "m"));
  };
  CHECK(watchdog("[0,5]") == R"(
start
success done
start in watchdog [0,5] s
state on time in watchdog [0,5] s
end in time in watchdog [0,5] s
error overshoot in watchdog [0,5] s
start -> done
start -> on time: starts
on time -> in time: ends
on time -> overshoot [forbidden]: after 5 s
)");
  CHECK(watchdog("]0,...[") == R"(
start
success done
start in watchdog ]0,...[ s
state early in watchdog ]0,...[ s
state on time in watchdog ]0,...[ s
end in time in watchdog ]0,...[ s
error undershoot in watchdog ]0,...[ s
start -> done
start -> early: starts
early -> on time: 0 s
on time -> in time: ends
early -> undershoot [forbidden]: ends
)");
}

TEST_CASE("an environment emits and chooses") {
  const auto p = program("(defevent e :effects (s X))\n"
                         "(defenvironment world :body ((while true (choose ((emit e)) ((^ 1))))))");
  CHECK(outline(picture(p, Kind::Body, "world")) == R"(
start
test true
test choose
event e
wait wait 1 s
start -> true
true -> choose [yes]: yes
choose -> e
choose -> wait 1 s
e -> true
wait 1 s -> true
)");
}

TEST_CASE("the call graph knows who calls and who interrupts whom") {
  const auto p = program(R"((defskill a :time_interval [1,2] :action (a))
(defskill b :action (b))
(defskill inner :body ((a) (a)))
(defskill main :body ((inner) (// ((b)) ((b.interrupt)))))
(defskill guard :monitor t :body ((b.interrupt)))))");
  CHECK(outline(picture(p, Kind::Calls)) == R"(
basic a {[1,2] s}
basic b
composite inner
mission main
monitor guard
inner -> a [calls]: ×2
main -> b [calls]
main -> b [interrupts]
main -> inner [calls]
guard -> b [interrupts]
)");
}

TEST_CASE("a composite skill has its body for a picture, a basic one has none") {
  const auto p = program("(defskill a :action (a)) (defskill m :body ((a)))");
  CHECK(outline(picture(p, Kind::Skill, "m")) == outline(picture(p, Kind::Body, "m")));
  CHECK(draw(p, {Kind::Body, "a", false}).error() == "the skill `a` is basic and has no body");
  CHECK(draw(p, {Kind::Skill, "x", false}).error() == "there is no skill `x`");
  CHECK(draw(p, {Kind::StateVariable, "x", false}).error() == "there is no state variable `x`");
}

TEST_CASE("all pictures of a program, kind by kind") {
  const auto p = program("(defskill m :body ((a))) (defsv s :states (X) :init X)\n"
                         "(defskill a :action (a)) (defenvironment e :body ((^ 1)))");
  std::vector<std::string> names;
  for (const auto& request : allPictures(p)) names.push_back(request.name);
  CHECK(names == std::vector<std::string>{"s", "a", "m", "e", ""});
}

TEST_CASE("nodes come from the text that they are about") {
  const auto p = program("(defskill a :input ($x int) :action (a))\n"
                         "(defskill m :body ((a x 1) (if (= a.status success) (^ 2))))");
  const auto graph = picture(p, Kind::Body, "m");
  std::vector<std::string> origins;
  for (const auto& node : graph.nodes) origins.push_back(origin(p, node));
  CHECK(origins == std::vector<std::string>{"m", "(a x 1)", "(= a.status success)", "(^ 2)", ")"});
  CHECK(graph.nodes[1].source.position == syntax::Position{1, 19});
}

TEST_CASE("half-typed programs have pictures too") {
  for (const auto* text :
       {"(defskill", "(defskill m :body ((if", "(defsv s :states (A", "(defskill m :body ((// ((a)",
        "(defskill m :body (break (goto x) (nothing.interrupt)))", "(defsv s :init 3)",
        "(defskill m :body ((do until (s X)) (^) (success)))", "(defenvironment e)"}) {
    INFO(text);
    const auto p = program(text);
    for (const auto& request : allPictures(p)) CHECK(draw(p, request));
  }
}

TEST_CASE("every node of every example has a place in its file") {
  for (const auto* path : {"drone/drone.proskill", "rover/rover.proskill", "arm/arm.proskill",
                           "lift/lift.proskill", "lift/timed.proskill"}) {
    const auto p = example(path);
    REQUIRE_FALSE(p.skills.all.empty());
    for (const auto& request : allPictures(p)) {
      INFO(path << " " << request.name);
      for (const auto& node : picture(p, request.kind, request.name, true).nodes) {
        CHECK_FALSE(node.source.range.empty());
        CHECK_FALSE(origin(p, node).empty());
      }
    }
  }
}

} // namespace proskill::test::pictures_test
