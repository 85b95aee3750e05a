#pragma once

#include "fiacre/syntax/tree.h"

#include <optional>
#include <utility>
#include <vector>

namespace proskill::fiacre {

/// Moves operands into a list; an initializer list would copy each with its whole tree.
template <class Node, class... More>
[[nodiscard]] std::vector<Node> operandsOf(Node first, More... more) {
  std::vector<Node> all;
  all.reserve(1 + sizeof...(more));
  all.push_back(std::move(first));
  (all.push_back(std::move(more)), ...);
  return all;
}

/// Whether a formula is about one moment, without temporal operators.
[[nodiscard]] inline bool isAtom(const Ltl& formula) { return formula.kind == LtlKind::Atom; }

/// The negation. The negation of an atom is an atom.
[[nodiscard]] Ltl negated(Ltl inner);

/// A pattern without scope and times as a formula; nothing for other patterns.
[[nodiscard]] std::optional<Ltl> asFormula(const Pattern& pattern);

} // namespace proskill::fiacre
