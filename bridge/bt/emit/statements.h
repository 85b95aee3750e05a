#pragma once

#include "bridge/bt/emit/calls.h"
#include "bridge/bt/emit/conditions.h"
#include "bridge/bt/emit/counted.h"
#include "bridge/bt/emit/exits.h"

#include <functional>

namespace proskill::bridge::bt {

/// Writes the statements of a body as a tree. A tree has two results, and statements may have more
/// ways out: so each way out is given one of the results. In a sequence the next statement is
/// reached by a success and all other ways by a failure, in a fallback it is the other way round.
/// Where ways out need another result than that, a flag on the blackboard distinguishes them.
class Statements {
public:
  Statements(Draft& draft, Conditions& conditions, Calls& calls, const CountedLoops& loops,
             const analysis::Definition<syntax::Skill>& skill)
      : draft(draft),
        conditions(conditions),
        calls(calls),
        loops(loops),
        skill(skill),
        file(skill.file) {}

  /// A body, which succeeds at its end.
  Element body();

private:
  static constexpr int kDeepest = 300; ///< of statements in statements, and jumps in a block

  /// What becomes of a way out: a script, if it is not empty, and then a result.
  struct Result {
    bool value = true;
    std::string script{};
  };
  using Results = std::map<std::string, Result, std::less<>>; ///< by way out
  using Part = std::function<Element(const Results&)>;

  Element block(const syntax::Block* block, const Results& results);
  Element steps(Steps steps, const Results& results);
  Element notTooDeep(Steps steps, const Results& results);
  Element row(Steps steps, const Results& results);
  Element atLabel(Steps steps, std::size_t label, const Results& results);
  /// What is repeated by jumps to the label before it.
  Element repeated(Steps steps, const syntax::Statement& label, const Results& results);
  Element repeatedFirst(Steps steps, std::size_t end, const syntax::Statement& label,
                        const Results& results);
  Element inTurn(const Exits& exits, syntax::Range at, const Results& results, const Part& first,
                 const Part& second);
  Element loop(const syntax::Statement& loop, const Results& results);
  Element round(const syntax::Statement& loop, const Results& results);
  Element counted(const Step& step, const Results& results);
  Element withRecovery(const Counted& loop, syntax::Range at, const Results& results);
  Element step(const Step& step, const Results& results);
  Element statement(const syntax::Statement& statement, const Results& results);
  Element call(const Step& step, const Results& results);
  /// What follows a success or a failure, which may be the same block; null: the next statement.
  Element either(Element test, const syntax::Block* onSuccess, const syntax::Block* onFailure,
                 const Results& results);
  Element caseOf(const syntax::Statement& statement, const Results& results);
  Element ifFrom(const syntax::Statement& statement, std::size_t arm, const Results& results);
  Element waitTime(const syntax::Statement& statement, const Results& results);
  Element waitCondition(const syntax::Statement& statement, const Results& results);
  Element parallel(const syntax::Statement& statement, const Results& results);
  Element branches(const syntax::Statement& statement, Results results, bool out);
  void checkBranches(const syntax::Statement& statement);
  Element set(const syntax::Statement& statement, const Results& results);
  std::string milliseconds(const syntax::Interval& duration);

  static Element leave(const Result& result);
  /// A node that succeeds, and then the way to the next statement.
  static Element thenNext(Element succeeding, const Results& results);
  static Element repeat(Element round, bool untilSuccess);
  /// The result that all these ways out have, failure if there are none; nothing if they have both.
  static std::optional<bool> common(const Exits& exits, const Results& results);
  /// The part with these ways out, which have one result in it.
  Element withCommon(const Exits& exits, syntax::Range at, const Results& results,
                     const std::function<Element(const Results&, bool)>& part);
  Element fail(syntax::Range at, std::string_view what);

  Draft& draft;
  Conditions& conditions;
  Calls& calls;
  const CountedLoops& loops;
  const analysis::Definition<syntax::Skill>& skill;
  analysis::FileId file;
  int flags = 0;
  int depth = 0;
};

} // namespace proskill::bridge::bt
