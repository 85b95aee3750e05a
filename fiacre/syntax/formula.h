#pragma once

#include "fiacre/syntax/tree.h"

#include <optional>
#include <utility>
#include <vector>

namespace proskill::fiacre {

/// Operands moved to where they stay: a list in braces would copy each with all that is below it.
template <class Node, class... More>
[[nodiscard]] std::vector<Node> operandsOf(Node first, More... more) {
  std::vector<Node> all;
  all.reserve(1 + sizeof...(more));
  all.push_back(std::move(first));
  (all.push_back(std::move(more)), ...);
  return all;
}

/// Whether a formula is of one moment.
[[nodiscard]] inline bool isAtom(const Ltl& formula) { return formula.kind == LtlKind::Atom; }

/// The negation; of a formula of one moment it is of one moment, too.
[[nodiscard]] Ltl negated(Ltl inner);

/// What a pattern without scope and times says of a run; nothing for others.
[[nodiscard]] std::optional<Ltl> asFormula(const Pattern& pattern);

} // namespace proskill::fiacre
