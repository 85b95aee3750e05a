#pragma once

#include "bridge/bt/emit/draft.h"
#include "bridge/bt/tree/traits.h"

#include <deque>
#include <map>
#include <set>

namespace proskill::bridge::bt {

/// The skills that a tree calls.
class Calls {
public:
  explicit Calls(Draft& draft) : draft(draft) {}

  /// A leaf for a basic skill, a `SubTree` for a composite one.
  Element call(const syntax::Statement& call, analysis::FileId file);
  /// The name of a skill's tree or leaf: trees must not have the names of built-in nodes.
  [[nodiscard]] static std::string nameOf(const analysis::Definition<syntax::Skill>& skill);
  /// The skills that are called in a block, by itself or by skills that it calls.
  [[nodiscard]] std::set<std::string_view> calledIn(const syntax::Block& block) const;
  /// The statuses that a call can have afterwards.
  [[nodiscard]] std::set<std::string_view> statusesOf(std::string_view skill) const;
  /// With what its node can end: it fails where the status is another one than success.
  [[nodiscard]] Ends endsOf(std::string_view skill) const;
  /// The arms of a `case` for a success, or for all other outcomes.
  [[nodiscard]] std::set<const syntax::Block*>
  armsFor(const syntax::Statement& statement, std::string_view skill, bool succeeded) const;
  /// Asks for a composite skill, as if it were called.
  void want(const analysis::Definition<syntax::Skill>& skill);

  [[nodiscard]] bool isKnown(std::string_view skill) const { return known.contains(skill); }

  std::deque<const analysis::Definition<syntax::Skill>*> composites; ///< in order of their calls
  std::vector<const analysis::Definition<syntax::Skill>*> leaves;

private:
  void checkFields(const analysis::Definition<syntax::Skill>& skill);
  void checkEffects(const analysis::Definition<syntax::Skill>& skill);
  std::string value(const syntax::Argument& argument, analysis::FileId file);

  Draft& draft;
  std::set<std::string_view> known;
};

} // namespace proskill::bridge::bt
