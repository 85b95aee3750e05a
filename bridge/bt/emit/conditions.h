#pragma once

#include "bridge/bt/emit/draft.h"
#include "bridge/bt/emit/variables.h"

#include <map>
#include <set>
#include <string>
#include <utility>

namespace proskill::bridge::bt {

/// Writes conditions as nodes that succeed where they hold.
class Conditions {
public:
  explicit Conditions(Draft& draft);

  /// A node for a test that is made in one instant.
  Element of(const syntax::Expr& test, analysis::FileId file);
  /// The tests of one instant that belong together: none of them may be about a variable that
  /// another one is about, since a tree reads one condition after the other.
  void begin() {
    seen.clear();
    hasReported = false;
  }
  /// The same without `begin()`.
  Element another(const syntax::Expr& test, analysis::FileId file);
  /// A node for a test that is made at each tick.
  Element ofGuard(const syntax::Expr& test, analysis::FileId file);
  /// Reports guards with variables that are tested elsewhere, too: in a tree, one of the two may
  /// see the other value. Call this after all tests have been written.
  void checkGuards();
  /// A script that changes entries of the blackboard; empty after an error.
  std::string script(const syntax::Effects& effects, analysis::FileId file);
  /// A script that gives the entries that are used their first values; empty if there are none.
  [[nodiscard]] std::string initially() const;

  /// The conditions that were written, and whether each may change.
  std::map<std::string, bool> conditions;
  Variables variables;

private:
  Element joined(const syntax::Expr& test, bool isAnd);
  Element test(const syntax::Name& variable, const syntax::Expr& value);
  Element reported(const syntax::StateVariable& variable, const syntax::Expr& state);
  Element world(const syntax::StateVariable& variable, std::string_view state, bool changes);
  /// An id that no other condition, variable, skill or built-in node has.
  [[nodiscard]] std::string freeId(std::string id, std::string_view variable) const;
  Element compared(const syntax::Expr& test, const char* sign);
  /// The value that a variable has after `(set (VARIABLE VALUE))`.
  std::string assigned(const syntax::StateVariable& variable, const syntax::Expr& expr);
  std::string value(const syntax::Expr& expr);
  std::string entry(const syntax::Name& variable);
  [[nodiscard]] bool isVariable(const syntax::Expr& expr) const;
  Element fail(const syntax::Expr& expr, std::string_view what);

  Draft& draft;
  std::set<std::string> skills; ///< their names in the tree
  std::map<std::pair<std::string_view, std::string_view>, std::string> ids; ///< by variable, state
  std::set<std::string_view> seen;
  std::map<std::string_view, std::size_t> tests; ///< by variable that events change
  std::map<std::string_view, analysis::Location> guarded;
  bool isGuard = false;
  std::set<std::string_view> entries;
  bool hasReported = false;
  analysis::FileId file = 0;
};

} // namespace proskill::bridge::bt
