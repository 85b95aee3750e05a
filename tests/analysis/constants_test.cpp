#include "analysis/program/program.h"
#include "tests/analysis/findings.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

using proskill::test::diagnose;
using proskill::test::findings;
using proskill::test::kWorld;
using proskill::test::mission;

namespace {

const std::string kConstants = "(defconst few 2)(defconst below -3)(defconst half 0.5)\n";

/// The findings in a program with these constants.
std::string with(const std::string& text) { return findings(kConstants + kWorld + text); }

std::string body(const std::string& statement) { return "(defskill m :body (" + statement + "))"; }

} // namespace

TEST_CASE("a constant may be wherever a number may") {
  CHECK(with("(defsv n :init few :min few :max few)") == "");
  CHECK(with("(defsv n :init (0 few) :min 0 :max few)") == "");
  CHECK(with("(defresource r :capacity few)") == "");
  CHECK(with("(defevent e :every [half,few[ :effects (level few))") == "");
  CHECK(with("(defskill s :input ($x float $n int) :time_interval ]half,few] :action (s below))"
             "(defskill m :body ((s x half n below) (^ few) (^ [half,few]) (^ (= level few))"
             " (^ (level few) :timeout half) (^ (> (+ level few) few) :timeout [0,few] (s x few n "
             "few))"
             " (printf \"%d\" few)))") == "");
  CHECK(with("(defproperty p (present (level few) :after (level 1) :lasting half))") == "");
  CHECK(with("(defproperty p (leadsto (level few) (level 1) :within [half,few]))") == "");
}

TEST_CASE("what a number must not be, its constant must not be either") {
  CHECK(with("(defsv n :init 0 :min 0 :max half)") == "PS0304 half");
  CHECK(with("(defsv n :init below :min 0 :max 1)") == "PS0304 below");
  CHECK(with("(defsv n :init few :min 0 :max 1)") == "PS0305 few");
  CHECK(with("(defresource r :capacity half)") == "PS0412 half");
  CHECK(findings(kConstants + mission("(set (level half))")) == "PS0304 half");
  CHECK(findings(kConstants + mission("(^ (< level below))")) == "PS0304 below");
  CHECK(with("(defskill s :input ($n nat) :action (s $n))" + body("(s n below)")) ==
        "PS0322 below");
  CHECK(with("(defskill s :time_interval [few,half] :action (s))") == "PS0410 [few,half]");
  CHECK(with("(defskill s :time_interval ]few,few] :action (s))") == "PS0411 ]few,few]");
  CHECK(findings(kConstants + mission("(^ below)")) == "PS0418 below");
  CHECK(findings(kConstants + mission("(^ [below,few])")) == "PS0418 below");
  CHECK(with("(defproperty p (present (level 1) :after (level 2) :lasting below))") ==
        "PS0418 below");
  CHECK(with("(defproperty p (present (level 1) :after (level 2) :lasting -1))") == "PS0418 -1");
  CHECK(diagnose(kConstants + mission("(^ below)")).at(0).message ==
        "a time cannot be negative, and this is -3");
}

TEST_CASE("a constant that does not exist") {
  CHECK(findings(kConstants + mission("(^ fwe)")) == "PS0212 fwe");
  CHECK(with("(defsv n :init 0 :min 0 :max fwe)") == "PS0212 fwe");
  CHECK(with("(defresource r :capacity fwe)") == "PS0212 fwe");
  CHECK(with("(defevent e :every [1,fwe] :effects (level 1))") == "PS0212 fwe");
  CHECK(with("(defskill s :input ($n nat) :action (s $n))" + body("(s n fwe)")) == "PS0212 fwe");
  CHECK(findings(kConstants + mission("(^ (= level fwe))")) == "PS0202 fwe");
  const auto found = diagnose(kConstants + mission("(^ (= level fwe))"));
  CHECK(found.at(0).fixes.at(0).text == "few");
}

TEST_CASE("a name has one meaning") {
  CHECK(findings("(defconst a 1)(defconst a 2)") == "PS0220 a");
  CHECK(findings("(defconst a 1)(defsv a :init 0 :min 0 :max 1)") == "PS0223 a");
  CHECK(findings("(defconst A 1)(defsv a :init A :states (A B))") == "PS0223 A");
  CHECK(findings("(defconst a 1)(defskill s :action (s) :success a)") == "PS0223 a");
  CHECK(findings("(defconst a 1)(defskill s :action (s a))") == "");
  CHECK(findings("(defconst success 1)") == "PS0222 success");
  CHECK(findings("(defconst no_result 1)") == "PS0222 no_result");
}

namespace {

namespace analysis = proskill::analysis;
using proskill::syntax::Document;

analysis::Program programOf(const Document& document) {
  return analysis::load(proskill::test::MemoryFiles(), "main.proskill", document);
}

proskill::syntax::Rational capacityOf(const analysis::Program& program, std::size_t resource) {
  return program.resources.all.at(resource).nodeAsRead().capacity->number;
}

} // namespace

TEST_CASE("an edit elsewhere leaves a definition with a constant as it was") {
  const Document before =
      Document::parse("(defconst few 2)\n(defresource r :capacity few)(defresource s)\n");
  const auto first = programOf(before);
  const auto second = programOf(before.edit({0, 0}, "; more\n"));
  const auto& there = *first.resources.all.at(0).form;
  const auto& here = *second.resources.all.at(0).form;
  CHECK(here.isSameRead(there));
  CHECK(here.range == there.range.moved(7));
  CHECK(here.name.range == there.name.range.moved(7));
}

TEST_CASE("an edit of a constant reaches the definitions with it") {
  const std::string text = "(defconst few 2)\n(defresource r :capacity few)\n";
  const Document two = Document::parse(text);
  const auto at = static_cast<proskill::syntax::Offset>(text.find('2'));
  const Document three = two.edit({at, at + 1}, "3");
  const Document none = two.edit({0, at + 3}, "");
  CHECK(capacityOf(programOf(two), 0) == proskill::syntax::Rational(2));
  CHECK(capacityOf(programOf(three), 0) == proskill::syntax::Rational(3));
  CHECK(capacityOf(programOf(two), 0) == proskill::syntax::Rational(2));
  CHECK(programOf(none).resources.all.at(0).nodeAsRead().capacity->kind ==
        proskill::syntax::ExprKind::Symbol);
  const Document other = two.edit({0, 0}, "(defresource q :capacity many)(defconst many 5)\n");
  CHECK(capacityOf(programOf(other), 0) == proskill::syntax::Rational(5));
  CHECK(capacityOf(programOf(other), 1) == proskill::syntax::Rational(2));
}
