#pragma once

#include "tests/fiacre/build.h"

#include <string>
#include <vector>

/// A model in which nothing is wrong, and what the check finds once a test has changed it.
namespace proskill::fiacre::test {

using Found = std::vector<std::string>;

/// Each problem as "place: message".
[[nodiscard]] Found problems(const Program& program);

/// A model with a bit of everything, in which nothing is wrong: two cells, a worker that it calls.
[[nodiscard]] Program clean();

/// The problems of the clean model with these statements as all that the worker does when it is
/// idle.
[[nodiscard]] Found whenIdle(std::vector<Statement> statements);

/// The same for an expression where a truth value is expected.
inline Found guard(Expr expr) { return whenIdle({on(std::move(expr)), to("busy")}); }

inline const std::string kIdle = "process worker, state idle: ";

/// The problems of the clean model with one change.
template <class Change> Found changed(Change change) {
  auto program = clean();
  change(program);
  return problems(program);
}

[[nodiscard]] Found onProperty(PatternKind kind, std::vector<Observable> operands);

} // namespace proskill::fiacre::test
