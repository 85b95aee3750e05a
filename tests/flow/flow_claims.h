#pragma once

#include "analysis/flow/flow.h"
#include "analysis/flow/result/report.h"
#include "codegen/model.h"
#include "tests/flow/judgement.h"
#include "tests/flow/questions.h"
#include "tests/support/texts.h"

#include <algorithm>
#include <initializer_list>

namespace proskill::test {

using namespace analysis::flow;
using analysis::Location;
using syntax::Code;
using syntax::Diagnostic;

/// Decisions of the engine.
struct Verdict {
  codegen::Check check;
  Location place;
  bool happens = false; ///< whether the tag, the state, or the property's condition can be reached
};

/// Compares the claims of the flow analysis on one program with the engine's answers.
class Judgement {
public:
  explicit Judgement(const std::string& source)
      : text(source),
        program(programOfText(text)),
        index(analysis::analyse(program)),
        valid(std::ranges::none_of(index.diagnostics, [](const Diagnostic& each) {
          return each.severity == syntax::Severity::Error;
        })) {}

  Judged result();

private:
  [[nodiscard]] std::string textWithQueries() const;

  // judge_flow.cpp: answers
  bool decide(const std::string& source);
  /// The generated name, which has a `_` if another one is equal.
  static std::string nameIn(const codegen::Model& model, const std::string& variable);
  /// A query that no property of ProSkill can express.
  void askOfModel(codegen::Model& model, std::size_t query) const;
  [[nodiscard]] const Verdict* find(std::string_view kind, Location place) const;
  [[nodiscard]] const Verdict* findOf(std::string_view kind, std::string_view subject) const;

  // refuted_claims.cpp: claims of "never"
  void refute(const std::string& words) { judged.refuted.push_back(words); }

  void judge(const Verdict& verdict);
  [[nodiscard]] bool judgeQuery(const Verdict& verdict) const;
  [[nodiscard]] bool reaches(Location place) const;
  [[nodiscard]] bool holdsPlace(const Process& process, Location place) const;
  [[nodiscard]] ProcessId processOf(std::string_view skill) const;
  [[nodiscard]] bool canRun(std::string_view skill) const;
  [[nodiscard]] bool returns(const Verdict& verdict, const std::string& kind) const;
  [[nodiscard]] bool reachesNode(const Verdict& verdict, NodeKind kind) const;
  /// Before its start, too.
  [[nodiscard]] bool mayBeInterrupted(const Verdict& verdict) const;
  [[nodiscard]] bool mayBeRefused(const Verdict& verdict) const;
  [[nodiscard]] bool mayBeRefused(Location place) const;
  [[nodiscard]] bool mayBeBusy(Location place) const;
  /// Whether the call with this first word calls the skill, directly or not.
  [[nodiscard]] bool leadsTo(Location head, ProcessId skill) const;
  [[nodiscard]] bool mayBreakPostcondition(Location place) const;
  [[nodiscard]] bool mayMiss(const Verdict& verdict) const;
  /// Undershoot of a run that is stopped is outside of the analysis.
  [[nodiscard]] bool mayBeCutShort(const Verdict& verdict) const;
  [[nodiscard]] bool isCutShort(ProcessId id) const;
  [[nodiscard]] bool mayMoveWrongly(const std::string& variable);

  // certain_claims.cpp: claims of "always"
  /// `happened` makes the claim relevant, `expected` must follow from it.
  void demand(const Diagnostic& claim, const Verdict* happened, const Verdict* expected);
  void judgeCertain(const Diagnostic& claim);
  /// A statement in the body of the `while` or `do` whose first word is at the place, unless the
  /// loop may be left: then somebody may end it at the instant at which it spins.
  /// Whether the statement with this first word is in the body of the skill.
  [[nodiscard]] bool isIn(std::string_view skill, Location head) const;
  [[nodiscard]] const Verdict* insideEndlessLoop(Location head) const;
  [[nodiscard]] bool spins(ProcessId id, Location loop) const;
  void demandOfSkill(const Diagnostic& claim, std::string_view kind);
  /// The program with the intervals that the analysis has found, and without transitions that are
  /// never made. These intervals must hold, and there must be no new forbidden moves.
  void judgeFixed();
  [[nodiscard]] bool isOneOfMore(const Diagnostic& claim) const;
  /// Whether a diagnostic has changed the interval of the verdict's skill.
  [[nodiscard]] bool isRewritten(const Verdict& verdict) const;
  /// The verdict about the step with the effects at this place.
  [[nodiscard]] const Verdict* whatSets(Location place) const;
  [[nodiscard]] const Verdict* occurs(std::string_view event) const;
  /// A guard that fails may end the skill before the step.
  [[nodiscard]] bool isGuarded(const Verdict& verdict) const;
  /// Of `set` only: a wait with effects may be reached and never end.
  [[nodiscard]] bool isSet(Location place) const;
  static bool within(Location inner, Location outer);
  [[nodiscard]] const Verdict* enclosing(Location place,
                                         std::initializer_list<std::string_view> kinds) const;

  std::string text;
  analysis::Program program;
  analysis::Analysis index;
  bool valid;
  Report* report = nullptr;
  std::vector<Query> queries;
  std::vector<Diagnostic> found;
  std::vector<Verdict> verdicts;
  Judged judged;
};

} // namespace proskill::test
