#include "ide/completion/completion.h"
#include "tests/ide/marked_program.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

using namespace proskill;
using test::MarkedProgram;

namespace {

const std::string kDefinitions = R"(
; Charge left.
(defsv battery :states (Good Low Critical) :init Good)
(defsv level :init 0 :min 0 :max 9)
(defevent empty :effects (battery Critical))
(defresource arm)
(defresource legs)
; Goes up.
(defskill takeoff
  :input ($height float $mode battery)
  :action (takeoff $height)
  :interrupt (:effects (battery Low))
  :success at_altitude
  :failure (grounded emergency))
(defskill watch :monitor t :body ((^ (battery Low))))
)";

ide::Completions completions(const MarkedProgram& program, ide::CompletionTrigger trigger = {}) {
  return ide::complete(program.snapshot(), program.view(), program.at(), trigger);
}

using Labels = std::vector<std::string>;

Labels labels(const MarkedProgram& program, ide::CompletionTrigger trigger = {}) {
  Labels result;
  for (const auto& item : completions(program, trigger).items) result.push_back(item.label);
  return result;
}

/// The completions at the cursor in a text after the definitions.
Labels labelsIn(const std::string& text) {
  INFO(text);
  return labels(MarkedProgram(kDefinitions + text));
}

ide::Completion itemIn(const std::string& text, std::string_view label) {
  const MarkedProgram program(kDefinitions + text);
  for (const auto& item : completions(program).items)
    if (item.label == label) return item;
  FAIL("no `" << label << "` in " << text);
  return {};
}

bool contains(const Labels& all, std::string_view label) {
  return std::ranges::find(all, label) != all.end();
}

const Labels kBattery{"Good", "Low", "Critical"};

} // namespace

TEST_CASE("the values of a state variable, behind its name") {
  for (const auto* text : {
           "(defsv lamp :states (Good Low Critical) :init ^)",
           "(defsv lamp :states (Good Low Critical) :init Good :transitions ((^",
           "(defsv lamp :states (Good Low Critical) :init Good :transitions ((Good L^ow)))",
           "(defevent e :effects (battery ^))",
           "(defevent e :effects ((level 3) (battery ^",
           "(defskill f :precondition (a (battery ^",
           "(defskill f :precondition (a (~ (battery G^))) :action (x))",
           "(defskill f :start (battery ^",
           "(defskill f :invariant (t (:guard (battery ^",
           "(defskill f :invariant (t (:guard (battery Low) :effects (battery ^))))",
           "(defskill f :success done (:effects (battery ^",
           "(defskill f :success (done (:postcondition (& (battery ^",
           "(defskill f :body ((^ (battery ^",
           "(defskill f :body ((^ (battery Low) :effects (battery ^",
           "(defskill f :body ((if (battery ^",
           "(defskill f :body ((if (battery Low) (set (battery ^",
           "(defskill f :body ((do (takeoff) until (battery ^",
           "(defskill f :body ((set ((level 2) (battery ^",
           "(defproperty p (always (battery ^",
           "(defproperty p (ltl ([] (=> (running takeoff) (<> (battery ^",
           "(defproperty p (leadsto (battery Low) (running takeoff) :after (battery ^",
           "(defproperty p (never (value battery ^",
       })
    CHECK(labelsIn(text) == kBattery);
}

TEST_CASE("a letter of linear temporal logic takes formulas, or values of a variable of its name") {
  CHECK(contains(labelsIn("(defproperty p (ltl (G (=> (running takeoff) (F (battery ^"), "Low"));
  CHECK(contains(labelsIn("(defproperty p (ltl (G ^"), "running"));
  CHECK(contains(labelsIn("(defproperty p (ltl (^"), "W"));
  CHECK_FALSE(contains(labelsIn("(defproperty p (always (^"), "W"));
  CHECK(contains(labelsIn("(defsv F :states (On Off)) (defproperty p (ltl (F ^"), "Off"));
}

TEST_CASE("inputs that have the values of a state variable") {
  const std::string skill = "(defskill f :input ($b battery $n level $x float) ";
  const auto behindBattery = Labels{"Good", "Low", "Critical", "$b"};
  CHECK(labelsIn(skill + ":precondition (a (battery ^") == behindBattery);
  CHECK(labelsIn(skill + ":start (battery ^") == behindBattery);
  auto values = labelsIn(skill + ":body ((if (= $b ^");
  CHECK(Labels(values.begin(), values.begin() + 4) == behindBattery);
  CHECK(contains(labelsIn(skill + ":body ((if (< ^"), "$n"));
  CHECK_FALSE(contains(labelsIn(skill + ":body ((if (< ^"), "$x"));
}

TEST_CASE("inputs that are truth values are conditions") {
  const std::string skill = "(defskill f :input ($a bool $b bool $x float) ";
  for (const std::string text :
       {":precondition (p ^", ":invariant (i (:guard ^", ":body ((if ^", ":body ((^ (not ^",
        ":body ((if (= ^", ":body ((while ^", ":success ok (:postcondition ^"}) {
    INFO(text);
    CHECK(contains(labelsIn(skill + text), "$a"));
    CHECK_FALSE(contains(labelsIn(skill + text), "$x"));
  }
  CHECK(labelsIn(skill + ":body ((if (= $a ^") == Labels{"true", "false", "$a", "$b"});
  CHECK_FALSE(contains(labelsIn(skill + ":body ((if (= battery ^"), "$a"));
  CHECK_FALSE(contains(labelsIn(skill + ":body ((if (< ^"), "$a"));
  CHECK_FALSE(contains(labelsIn(skill + ":body ((if (^"), "$a"));
  CHECK_FALSE(contains(labelsIn("(defproperty p (always ^"), "$a"));
  const auto printed = labelsIn(skill + ":body ((printf \"%s\" ^");
  CHECK(std::ranges::count(printed, "$a") == 1);
  CHECK(std::ranges::count(printed, "$x") == 1);
}

TEST_CASE("beside a value of a comparison, what it can be compared with comes first") {
  auto values = labelsIn("(defskill f :body ((if (= battery ^");
  CHECK(Labels(values.begin(), values.begin() + 3) == kBattery);
  CHECK(contains(values, "level"));
  CHECK(labelsIn("(defskill f :body ((if (= takeoff.status ^") ==
        Labels{"no_status", "success", "failure", "failed_inv", "interrupted"});
  CHECK(labelsIn("(defskill f :body ((if (/= takeoff.res ^") ==
        Labels{"at_altitude", "grounded", "emergency", "no_result"});
  CHECK(labelsIn("(defproperty p (never (ended takeoff ^") ==
        Labels{"no_status", "success", "failure", "failed_inv", "interrupted"});
  CHECK(labelsIn("(defskill f :body ((if (< ^") == Labels{"level", "+", "-"});
}

TEST_CASE("behind the point of a skill") {
  CHECK(labelsIn("(defskill f :body ((if (= takeoff.^") == Labels{"status", "res"});
  CHECK(labelsIn("(defskill f :body ((takeoff.^") == Labels{"interrupt"});
  CHECK(labelsIn("(defskill f :body ((if (= nobody.^").empty());
  const MarkedProgram program(kDefinitions + "(defskill f :body ((if (= takeoff.[[st^a]]tus");
  CHECK(completions(program).insert.begin == program.marked().front().range.begin);
  CHECK(completions(program).insert.end == program.at());
}

TEST_CASE("the fields that are not there yet") {
  CHECK(labelsIn("(defsv lamp ^") == Labels{":states", ":init", ":transitions", ":min", ":max"});
  CHECK(labelsIn("(defsv lamp :states (A B) ^)") == Labels{":init", ":transitions"});
  CHECK(labelsIn("(defsv lamp :min 0 :i^") == Labels{":init", ":max"});
  CHECK(labelsIn("(defevent e ^)") == Labels{":every", ":guard", ":effects"});
  CHECK(labelsIn("(defresource r :^)") == Labels{":capacity"});
  CHECK(labelsIn("(defenvironment e ^)") == Labels{":body"});
  CHECK(labelsIn("(defskill f :invariant (t (:guard (battery Low) ^") == Labels{":effects"});
  CHECK(labelsIn("(defskill f :interrupt (^") == Labels{":effects"});
  CHECK(labelsIn("(defskill f :failure (bad (:postcondition true ^") == Labels{":effects"});
  CHECK(labelsIn("(defskill f :body ((^ (battery Low) ^") == Labels{":effects", ":timeout"});
  CHECK(labelsIn("(defskill f :body ((^ [1,2] ^") == Labels{":effects", ":timeout"});
  CHECK(labelsIn("(defproperty p (present (running takeoff) ^") ==
        Labels{":after", ":before", ":within", ":for", ":fair", ":lasting"});
  CHECK(labelsIn("(defproperty p (ltl (running takeoff) :fair ^") ==
        Labels{"nil", "t", "(skill …)"});
}

TEST_CASE("nothing is offered in a list where only a keyword fits") {
  CHECK(labelsIn("(defskill f :body ((^ [1,2] (^)))").empty());
  CHECK(labelsIn("(defskill f (^").empty());
  CHECK(labelsIn("(defsv f (^)").empty());
  CHECK(labelsIn("(defskill f :success (done (:postcondition (battery Low) (^").empty());
}

TEST_CASE("a basic skill has no body, a composite one no action") {
  auto basic = labelsIn("(defskill f :action (f) ^)");
  CHECK(contains(basic, ":success"));
  CHECK_FALSE(contains(basic, ":action"));
  CHECK_FALSE(contains(basic, ":body"));
  auto composite = labelsIn("(defskill f ^ :body ())");
  CHECK(contains(composite, ":monitor"));
  auto behind = labelsIn("(defskill f :body () ^)");
  CHECK_FALSE(contains(behind, ":action"));
}

TEST_CASE("a parenthesis that is missing in the line above does not matter to a field") {
  CHECK(labelsIn("(defskill f\n  :precondition (a (battery \n  :success done\n  :resources (^") ==
        Labels{"arm", "legs"});
  auto fields = labelsIn(
      "(defskill f\n  :precondition (a (battery \n  :success done (:effects (battery Low))\n  ^");
  CHECK(contains(fields, ":failure"));
  CHECK_FALSE(contains(fields, ":success"));
}

TEST_CASE("names of the right kind") {
  CHECK(labelsIn("(defskill f :resources (arm ^") == Labels{"legs"});
  CHECK(labelsIn("(defskill f :input ($x ^") ==
        Labels{"int", "nat", "float", "bool", "string", "battery", "level"});
  CHECK(labelsIn("(defskill f :input ($x int $y ba^") ==
        Labels{"int", "nat", "float", "bool", "string", "battery", "level"});
  CHECK(labelsIn("(defskill f :body ((label here) (goto ^)))") == Labels{"here"});
  CHECK(labelsIn("(defskill f :success (a b) :failure c :body ((success ^)))") == Labels{"a", "b"});
  CHECK(labelsIn("(defskill f :success (a b) :failure c :body ((failure ^)))") == Labels{"c"});
  CHECK(labelsIn("(defenvironment e :body ((emit ^)))") == Labels{"empty"});
  CHECK(labelsIn("(defproperty p (reachable (occurs ^)))") == Labels{"empty"});
  CHECK(labelsIn("(defproperty p (reachable (running ^)))") == Labels{"takeoff", "watch"});
  CHECK(labelsIn("(defskill f :body ((label here))) (defproperty p (reachable (at ^)))") ==
        Labels{"here"});
  CHECK(labelsIn("(defskill f :input ($x int $y int) :action (go ^)") == Labels{"$x", "$y"});
  CHECK(labelsIn("(defskill f :input ($x int) :action (go $^)") == Labels{"$x"});
  CHECK(labelsIn("(defsv lamp :states (A) :init A :transitions ^") == Labels{":all"});
  CHECK(labelsIn("(defskill f :monitor ^") == Labels{"t", "always"});
  CHECK(labelsIn("(defskill f :interruptible ^") == Labels{"nil", "t"});
}

TEST_CASE("a wait has a timeout, and statements behind it") {
  const std::string wait = "(defskill f :body ((^ (battery Good) ";
  CHECK(labelsIn(wait + "^") == Labels{":effects", ":timeout"});
  CHECK(labelsIn(wait + ":timeout 5 (^").front() == "takeoff");
  CHECK(contains(labelsIn(wait + ":timeout 5 ^"), ":effects"));
  CHECK(contains(labelsIn(wait + ":timeout 5 (takeoff) ^"), "while"));
}

TEST_CASE("the call of a case, its outcomes and their tags") {
  const std::string body = "(defskill go :success (near far) :failure lost :invariant (dry "
                           "(:guard (battery Good))) :action (go)) (defskill f :body (";
  CHECK(contains(labelsIn(body + "(case ^"), "go"));
  CHECK(labelsIn(body + "(case (^").front() == "takeoff");
  const Labels outcomes{"success", "failure", "failed_inv", "interrupted", "refused", "else"};
  CHECK(labelsIn(body + "(case (go) ^") == outcomes);
  CHECK(labelsIn(body + "(case (go) (^") == outcomes);
  CHECK(labelsIn(body + "(case (go) ((^") == outcomes);
  CHECK(labelsIn(body + "(case (go) ((success ^") == Labels{"near", "far"});
  CHECK(labelsIn(body + "(case (go) ((success near ^") == Labels{"far"});
  CHECK(labelsIn(body + "(case (go) ((failure ^") == Labels{"lost"});
  CHECK(labelsIn(body + "(case (go) ((failed_inv ^") == Labels{"dry"});
  CHECK(contains(labelsIn(body + "(case (go) (success ^"), "while"));
  CHECK(contains(labelsIn(body + "(case (go) ((success near) ^"), "while"));
  CHECK(itemIn(body + "(case (go) ^", "success").snippet == "(success $0)");
}

TEST_CASE("Enter after a whole word inserts nothing") {
  const std::string skill = "(defskill f ";
  for (const auto& [text, word] :
       std::map<std::string, std::string>{{":bod^", ":body"},
                                          {":body ((if (a) (go) els^", "else"},
                                          {":body ((d^", "do"},
                                          {":monitor t :inter^", ":interrupt"}}) {
    const auto item = itemIn(skill + text, word);
    CHECK(item.insert == word);
    CHECK_FALSE(item.snippet.starts_with(word + "\n"));
  }
  CHECK(itemIn(skill + ":body (d^", "do").snippet == "(do\n  $0\nuntil ($1))");
}

TEST_CASE("a call brings its named arguments") {
  const std::string body = "(defskill f :input ($height float) :body (";
  auto head = itemIn(body + "(tak^", "takeoff");
  CHECK(head.snippet == "takeoff height ${1:\\$height} mode ${2|Good,Low,Critical|}");
  CHECK(head.insert == "takeoff");
  auto bare = itemIn(body + "tak^", "takeoff");
  CHECK(bare.snippet == "(takeoff height ${1:\\$height} mode ${2|Good,Low,Critical|})");
  CHECK(bare.insert == "(takeoff)");
  CHECK(bare.filter == "takeoff");
  CHECK(labelsIn(body + "(takeoff ^") == Labels{"height", "mode"});
  CHECK(labelsIn(body + "(takeoff height 3 ^") == Labels{"mode"});
  CHECK(labelsIn(body + "(takeoff mode ^") == Labels{"Good", "Low", "Critical", "$height"});
  CHECK(labelsIn(body + "(takeoff height ^") == Labels{"$height"});
}

TEST_CASE("statements where a statement stands, and no monitor among the calls") {
  auto statements = labelsIn("(defskill f :body ((^)))");
  for (const auto* label :
       {"takeoff", "^", "if", "while", "do", "//", "goto", "success", "set", "takeoff.interrupt"})
    CHECK(contains(statements, label));
  for (const auto* label : {"watch", "f", "emit", "choose", "elseif", "until", "battery"})
    CHECK_FALSE(contains(statements, label));
  CHECK(statements.front() == "takeoff");
  CHECK(contains(labelsIn("(defskill f :body ((if (battery Low) (takeoff) ^"), "elseif"));
  CHECK(contains(labelsIn("(defskill f :body ((do (takeoff) ^"), "until"));
  auto environment = labelsIn("(defenvironment e :body ((^)))");
  CHECK(contains(environment, "emit"));
  CHECK_FALSE(contains(environment, "takeoff"));
  CHECK_FALSE(contains(environment, "success"));
  CHECK(labelsIn("(defskill f :body ((// ((^").size() == statements.size());
}

TEST_CASE("conditions, with their parentheses where they are not there") {
  CHECK(itemIn("(defskill f :body ((if ^", "battery").snippet ==
        "(battery ${1|Good,Low,Critical|})");
  CHECK(itemIn("(defskill f :body ((if (^", "battery").insert == "battery");
  CHECK(itemIn("(defskill f :body ((if ^", "and").snippet == "(and ($1) ($0))");
  CHECK(contains(labelsIn("(defproperty p (always (^"), "running"));
  CHECK_FALSE(contains(labelsIn("(defproperty p (always (^"), "<>"));
  CHECK(contains(labelsIn("(defproperty p (ltl (^"), "<>"));
  CHECK_FALSE(contains(labelsIn("(defskill f :body ((if (^"), "running"));
  CHECK(contains(labelsIn("(defproperty p (^"), "leadsto"));
}

TEST_CASE("definitions at the top level, in whatever is open above") {
  CHECK(contains(labelsIn("\n(^"), "defskill"));
  CHECK(contains(labelsIn("\ndefs^"), "defskill"));
  CHECK(contains(labels(MarkedProgram("(defskill f :body ((takeoff\n(de^")), "defskill"));
  CHECK(contains(labels(MarkedProgram("^")), "defsv"));
}

TEST_CASE("nothing in comments, in texts, in numbers, and where a new name is due") {
  for (const auto* text :
       {"; battery ^", "(defskill f :body ((printf \"battery ^\")))", "(defsv ^", "(defskill f^",
        "(defsv lamp :states (^", "(defsv lamp :max 1^", "(defskill f :precondition (^",
        "(defskill f :time_interval [1,^", "(defskill f :body ((label ^", "(defskill f :input (^",
        "(defskill f :body ((printf ^"})
    CHECK(labelsIn(text).empty());
}

TEST_CASE("a space brings only what is one of a few") {
  auto typed = [](const std::string& text, char c) {
    return labels(MarkedProgram(kDefinitions + text), {.typed = c});
  };
  CHECK(typed("(defevent e :effects (battery ^", ' ') == kBattery);
  CHECK(typed("(defskill f :body ((takeoff ^", ' ') == Labels{"height", "mode"});
  CHECK(typed("(defskill f :body ((takeoff) ^", ' ').empty());
  CHECK(typed("(defskill f ^", ' ').empty());
  CHECK_FALSE(typed("(defskill f :^", ':').empty());
  CHECK_FALSE(typed("(defskill f :body ((^", '(').empty());
  CHECK(typed("(defskill f :body ((printf \"50.^\")))", '.').empty());
}

TEST_CASE("paths of the workspace's files") {
  const std::map<std::string, std::string> files{
      {"main.proskill", "(include \"^\")\n(include \"lamp.proskill\")"},
      {"lamp.proskill", ""},
      {"door10.proskill", ""},
      {"door2.proskill", ""},
      {"deep/lift.proskill", ""}};
  CHECK(labels(MarkedProgram(files)) ==
        Labels{"door2.proskill", "door10.proskill", "deep/lift.proskill"});
}

TEST_CASE("an item tells the comment above its definition, and the manual's sentence") {
  auto skill = itemIn("(defskill f :body ((^", "takeoff");
  const MarkedProgram program(kDefinitions);
  CHECK(ide::documentation(program.view(), skill).markdown().contains("Goes up."));
  CHECK(ide::documentation(program.view(), skill)
            .markdown()
            .contains("```proskill\n(defskill takeoff"));
  auto field = itemIn("(defskill f ^", ":start");
  CHECK(ide::documentation(program.view(), field).plain() ==
        ":start EFFECTS\n\nEffects that happen when the skill starts.");
}

TEST_CASE("of very many names the best are given, and it is said that there are more") {
  std::string text;
  for (int i = 0; i < 300; ++i)
    text += "(defsv v" + std::to_string(i) + " :states (A B) :init A)\n";
  const MarkedProgram all(text + "(defevent e :effects (^");
  CHECK_FALSE(completions(all).isComplete);
  CHECK(completions(all).items.size() == 200);
  const MarkedProgram one(text + "(defevent e :effects (v299^");
  CHECK(completions(one).items.size() == 1);
  const MarkedProgram few(kDefinitions + "(defevent e :effects (^");
  CHECK(completions(few).isComplete);
}

TEST_CASE("the word that the cursor stands in is replaced") {
  const MarkedProgram program(kDefinitions + "(defevent e :effects (battery [[Go^od]]))");
  const auto found = completions(program);
  CHECK(found.replace == program.marked().front().range);
  CHECK(found.insert.begin == found.replace.begin);
  CHECK(found.insert.end == program.at());
}

TEST_CASE("constants where a number is expected, with their values") {
  const std::string constants = "(defconst patience 60)(defconst half 0.5)";
  const Labels kBoth{"patience", "half"};
  const auto offered = [&](const std::string& text) { return labelsIn(constants + text); };
  CHECK(offered("(defsv n :init 0 :min 0 :max ^)") == kBoth);
  CHECK(offered("(defresource r :capacity p^)") == kBoth);
  CHECK(offered("(defskill m :time_interval [p^") == kBoth);
  CHECK(offered("(defskill m :time_interval [1,p^])") == kBoth);
  CHECK(offered("(defskill m :body ((^ (level 1) :timeout p^") == kBoth);
  CHECK(contains(offered("(defskill m :body ((^ p^"), "patience"));
  CHECK(contains(offered("(defskill m :body ((takeoff height ^"), "half"));
  CHECK_FALSE(contains(offered("(defskill m :body ((takeoff mode ^"), "half"));
  CHECK(contains(offered("(defskill m :body ((set (level ^"), "patience"));
  CHECK(contains(offered("(defskill m :precondition (a (< level ^"), "patience"));
  CHECK(itemIn(constants + "(defresource r :capacity ^)", "half").detail == "half = 0.5");
}
