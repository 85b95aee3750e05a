#include "ide/verdicts/size_explanation.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

namespace proskill::test::size_explanation_test {

namespace {

struct Explained {
  explicit Explained(const std::string& text, verify::Options options = {})
      : program(test::programOfText(text)),
        model(codegen::generate(program, {}).value()),
        size(ide::explainSize(program, model, {}, std::move(options)).value()) {}

  [[nodiscard]] const ide::SizeRow* row(const std::string& name) const {
    const auto found = std::ranges::find(size.rows, name, &ide::SizeRow::name);
    return found == size.rows.end() ? nullptr : &*found;
  }
  [[nodiscard]] std::string adviceOn(const std::string& name) const {
    std::string all;
    for (const auto& sentence : row(name)->advice) all += sentence;
    return all;
  }

  analysis::Program program;
  codegen::Model model;
  ide::SizeExplanation size;
};

/// A monitor that counts its alarms, and tests the count.
std::string counting(const std::string& name, int most) {
  return "(defsv " + name + " :init 0 :min 0 :max " + std::to_string(most) + ")\n(defsv alarm_" +
         name + " :states (On Off) :init Off :transitions :all)\n(defevent ring_" + name +
         " :effects (alarm_" + name + " On))\n(defskill watch_" + name +
         " :monitor t :body ((while true (^ (alarm_" + name + " On)) (set (alarm_" + name +
         " Off)) (if (< " + name + " " + std::to_string(most) + ") (set (" + name + " (+ " + name +
         " 1))) else (set (" + name + " 0))))))\n";
}

verify::Options everything() {
  verify::Options options;
  options.reductions.clear();
  return options;
}

} // namespace

TEST_CASE("a part that is independent of the others multiplies by all of its values") {
  const Explained found("(defsv a :states (X Y Z) :init X :transitions :all)\n"
                        "(defsv b :states (P Q) :init P :transitions :all)\n"
                        "(defevent x :effects (a X)) (defevent y :effects (a Y))\n"
                        "(defevent z :effects (a Z)) (defevent p :effects (b P))\n"
                        "(defevent q :effects (b Q))\n",
                        everything());
  CHECK(found.size.counts.complete);
  CHECK(found.size.counts.classes == 6);
  REQUIRE(found.size.rows.size() == 2);
  CHECK(found.size.rows[0].name == "a");
  CHECK(found.row("a")->factor == Approx(3));
  CHECK(found.row("b")->factor == Approx(2));
  CHECK(found.size.kinds.empty()); // all is of one kind
}

TEST_CASE("a number that nothing asks about is found, with its line") {
  const Explained found(counting("n", 6) + counting("m", 2));
  CHECK(found.size.counts.complete);
  REQUIRE(found.row("n"));
  REQUIRE(found.row("m"));
  CHECK(found.row("n")->values == 7);
  CHECK(found.row("n")->factor > 6);
  CHECK(found.row("m")->factor > 2);
  CHECK(found.size.rows[0].name == "n");
  CHECK(found.adviceOn("n").find("No property of the program is about its value") !=
        std::string::npos);
  CHECK(found.program.files[0].document.text().substr(found.row("n")->location->range.begin, 2) ==
        "n ");
}

TEST_CASE("parts of one kind have a factor together") {
  const Explained found(counting("n", 6) + counting("m", 2));
  const auto variables =
      std::ranges::find(found.size.kinds, "all state variables", &ide::SizeRow::name);
  REQUIRE(variables != found.size.kinds.end());
  CHECK(variables->factor > found.row("n")->factor * found.row("m")->factor);
}

TEST_CASE("what follows from the rest does not multiply") {
  const Explained found("(defsv n :states (A B) :init A)\n"
                        "(defskill go :time_interval [1,2] :action (g))\n"
                        "(defskill m :body ((go) (set (n B)) (go)))\n");
  CHECK(found.row("n") == nullptr);
  CHECK(found.row("go") == nullptr);
  for (const auto& sentence : ide::sizeSummary(found.size))
    CHECK(sentence.find("are counted here") == std::string::npos);
}

TEST_CASE("the clock of a watchdog is found, with the line of its interval") {
  const Explained found("(defsv go :states (Yes No) :init Yes)\n(defevent stop :effects (go No))\n"
                        "(defskill look :time_interval [1,2] :action (l))\n"
                        "(defskill m :time_interval [50,100] :body ((while (go Yes) (look))))\n");
  const auto* row = found.row("watchdog of m");
  REQUIRE(row);
  CHECK(row == &found.size.rows[0]);
  CHECK(row->clocks > 0);
  CHECK(row->factor > 10);
  CHECK(found.adviceOn("watchdog of m").find("`:time_interval` of `m`") != std::string::npos);
  REQUIRE(row->location);
}

TEST_CASE("a sensor that may change at any moment is named with its events") {
  const Explained found("(defsv wind :states (Calm Strong) :init Calm :transitions :all)\n"
                        "(defevent calms :effects (wind Calm))\n"
                        "(defevent blows :effects (wind Strong))\n"
                        "(defskill m :body ((^ 1) (^ (wind Strong)) (^ 1)))\n",
                        everything());
  REQUIRE(found.row("wind"));
  CHECK(found.adviceOn("wind").starts_with("`calms`, `blows` may change it at any moment"));
}

TEST_CASE("where a limit ends the counting, the rest is not claimed") {
  verify::Options options;
  options.limits.classes = 10;
  const Explained found(counting("n", 6) + counting("m", 2), options);
  CHECK_FALSE(found.size.counts.complete);
  CHECK(found.size.counts.classes > 0);
  CHECK(ide::sizeSummary(found.size)[0].find("There are more classes than are counted here") == 0);
}

TEST_CASE("properties that are explored apart are named") {
  const Explained found(counting("n", 2) + "(defproperty p (leadsto (running watch_n) (n 2)))\n"
                                           "(defproperty q (longest (n 1) (n 2)))\n"
                                           "(defproperty r (always (alarm_n Off)))\n");
  CHECK(found.size.apart == std::vector<std::string>{"p", "q"});
}

} // namespace proskill::test::size_explanation_test
