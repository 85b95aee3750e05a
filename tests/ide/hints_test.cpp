#include "ide/features/inlay_hints.h"
#include "tests/ide/marked_program.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

using namespace proskill;
using test::MarkedProgram;

namespace {

/// The text with its hints in braces.
std::string hinted(const ide::View& view, syntax::Range range) {
  auto result = view.text();
  auto hints = ide::inlayHints(view, range);
  for (auto it = hints.rbegin(); it != hints.rend(); ++it)
    result.insert(it->at, "{" + it->label + "}");
  return result;
}

std::string hinted(const ide::View& view) {
  return hinted(view, {0, static_cast<syntax::Offset>(view.text().size())});
}

std::string hinted(const std::string& text) {
  const MarkedProgram program(text);
  return program.marked().empty() ? hinted(program.view())
                                  : hinted(program.view(), program.marked().front().range);
}

/// A program that is edited.
class Edited {
public:
  explicit Edited(const std::string& text) : program(text) {}

  /// Replaces the first occurrence of a text.
  void replace(std::string_view old, std::string_view put) {
    auto texts = current().open();
    auto& document = texts.at(kPath).document;
    const auto at = static_cast<syntax::Offset>(document.text().find(old));
    document = document.edit({at, at + static_cast<syntax::Offset>(old.size())}, put);
    ++texts.at(kPath).version;
    auto graph = ide::graphOf(test::MemoryFiles(), texts);
    next = current().with(std::move(texts), std::move(graph));
    (void)view(); // an editor asks after each edit
  }
  [[nodiscard]] ide::View view() const { return current().view(kPath); }

private:
  static constexpr const char* kPath = "/w/main.proskill";

  [[nodiscard]] const ide::Snapshot& current() const { return next ? *next : program.snapshot(); }

  MarkedProgram program;
  std::shared_ptr<const ide::Snapshot> next;
};

void check(const std::string& text, const std::string& part) {
  CHECK_THAT(hinted(text), Catch::Matchers::Contains(part));
}

const std::string kGo = "(defskill go :input ($x float) :time_interval [1,3] :action (go $x)\n"
                        "  :success a :failure b)\n";

} // namespace

TEST_CASE("literals in calls show the types of their inputs, bodies how long they take") {
  check(kGo + "(defskill m :body ((go x 3) (go x 4.5)))",
        "(defskill m{2 to 6 s} :body ((go x{: float} 3) (go x{: float} 4.5)))");
  check(kGo + "(defskill m :input ($y float) :body ((go x $y)))", "((go x $y))");
  check(kGo + "(defskill m :body ((go x 3) (go y 1) (nobody x 1)))",
        "(go x{: float} 3) (go y 1) (nobody x 1)");
  check("(defskill m :body ((while true (^ 1))))", "(defskill m{never ends}");
  check("(defskill m :body ((^ [2,...[)))", "(defskill m{at least 2 s}");
}

TEST_CASE("what is tested shows what it can be, where that is less than elsewhere") {
  check(kGo + "(defskill m :body ((go x 3) (if (= go.status success) (^ 1))))",
        "(= go.status{= success or failure} success)");
  const std::string lamp = "(defsv lamp :states (On Off Dim) :init Off)\n";
  check(lamp + "(defskill m :body ((set (lamp On)) (if (lamp On) (^ 1)) (set (lamp Dim))))",
        "(if (lamp{= On} On)");
  // Others may set it at any time, so nothing is known beyond the definition.
  check(lamp + "(defevent e :effects (lamp On)) (defevent f :effects (lamp Off))"
               "(defevent g :effects (lamp Dim))"
               "(defskill m :body ((set (lamp On)) (if (lamp On) (^ 1))))",
        "(if (lamp On)");
}

TEST_CASE("of many values the one is told that it cannot be") {
  const std::string mode = "(defsv mode :states (A B C D E) :init A)\n"
                           "(defevent b :effects (mode B)) (defevent c :effects (mode C))"
                           "(defevent d :effects (mode D)) (defevent e :effects (mode E))\n";
  check(mode + "(defskill m :body ((set (mode B)) (if (mode C) (^ 1))))", "(if (mode{≠ A} C)");
}

TEST_CASE("guards, which are looked at all the time, and bodies that take any time have no hints") {
  check("(defsv lamp :states (On Off) :init On) (defevent e :effects (lamp Off))"
        "(defskill m :invariant (t (:guard (lamp On))) :body ((^ (lamp Off))))",
        "(defskill m :invariant (t (:guard (lamp On)))");
}

TEST_CASE("hints are for the range that was asked for") {
  check(kGo + "(defskill m :body ((go x 3) [[(go x 4)]] (go x 5)))",
        "(defskill m :body ((go x 3) (go x{: float} 4) (go x 5)))");
}

TEST_CASE("a program with errors keeps what does not need its flow") {
  check(kGo + "(defskill m :body ((go x 3) (if (= go.status nonsense) (^ 1))))",
        "(defskill m :body ((go x{: float} 3) (if (= go.status nonsense)");
}

TEST_CASE("while a program has errors its hints stay") {
  Edited program("(defsv lamp :states (On Off Dim) :init Off)\n" + kGo +
                 "(defskill m :body ((go x 3) (if (= go.status success) (^ 1))\n"
                 "  (set (lamp On)) (if (lamp On) (^ 1)) (set (lamp Dim))))\n");
  const auto whole = hinted(program.view());
  REQUIRE_THAT(whole,
               Catch::Matchers::Contains("m{2 to 5 s}") && Catch::Matchers::Contains("{= On}"));

  program.replace("(defskill m", "(defskill\n(defskill m"); // in another definition
  CHECK(hinted(program.view()) == whole.substr(0, whole.find("(defskill m")) + "(defskill\n" +
                                      whole.substr(whole.find("(defskill m")));
  program.replace("(defskill\n", "");
  CHECK(hinted(program.view()) == whole);

  program.replace("x 3", "x "); // in the same definition
  program.replace("x ", "x ("); // by several edits
  const auto broken = hinted(program.view());
  CHECK_THAT(broken, Catch::Matchers::Contains("m{2 to 5 s}"));
  CHECK_THAT(broken, Catch::Matchers::Contains("go.status{= success or failure}"));
  CHECK_THAT(broken, Catch::Matchers::Contains("(if (lamp{= On} On)"));
}

TEST_CASE("a hint goes when the text at its place is edited, or its skill has another name") {
  const std::string lamp = "(defsv lamp :states (On Off Dim) :init Off)\n"
                           "(defskill m :body ((set (lamp On)) (if (lamp On) (^ 1)) "
                           "(set (lamp Dim))))\n";
  Edited word(lamp);
  REQUIRE_THAT(hinted(word.view()), Catch::Matchers::Contains("(if (lamp{= On} On)"));
  word.replace("(if (lamp", "(if (lamps");
  CHECK_THAT(hinted(word.view()), Catch::Matchers::Contains("(if (lamps On)"));
  word.replace("(if (lamps", "(if (lam");
  CHECK_THAT(hinted(word.view()), Catch::Matchers::Contains("(if (lam On)"));
  Edited name(lamp);
  name.replace("(defskill m", "(defskill mm");
  name.replace("(set", "(sett");
  CHECK_THAT(hinted(name.view()), Catch::Matchers::Contains("(if (lamp{= On} On)"));
  name.replace("(defskill mm", "(defskill other");
  CHECK_THAT(hinted(name.view()), Catch::Matchers::Contains("(if (lamp On)"));
}

TEST_CASE("kept hints say that they are older, and lead nowhere") {
  Edited program(kGo + "(defskill m :body ((go x 3) (if (= go.status success) (^ 1))))");
  program.replace("(^ 1)", "(^ )");
  const auto view = program.view();
  const auto end = static_cast<syntax::Offset>(view.text().size());
  const auto hints = ide::inlayHints(view, {0, end});
  REQUIRE(hints.size() == 3);
  for (const auto& hint : hints) {
    const bool isKept = hint.kind != ide::HintKind::ArgumentType;
    CHECK(hint.tooltip.ends_with("As of the last text without errors.") == isKept);
    CHECK(hint.about.has_value() != isKept);
    const auto alone = ide::inlayHints(view, {hint.at - 1, hint.at}); // as when it is resolved
    REQUIRE(alone.size() == 1);
    CHECK(alone.front().label == hint.label);
  }
  view.owner->forgetFlow();
  CHECK(ide::inlayHints(view, {0, end}).size() == 1);
}

TEST_CASE("a debugger shows each state variable once a line, up to the end of the range") {
  const MarkedProgram program("(defsv lamp :states (On Off) :init Off)\n"
                              "[[(defskill m :body ((^ (| (lamp On) (lamp Off)))\n"
                              "  (set (lamp On)))]] (set (lamp Off))))");
  std::vector<std::string> names;
  for (const auto& variable : ide::inlineVariables(program.view(), program.marked().front().range))
    names.push_back(variable.name);
  CHECK(names == std::vector<std::string>{"lamp", "lamp"});
}
