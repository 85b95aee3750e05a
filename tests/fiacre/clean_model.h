#pragma once

#include "tests/fiacre/build.h"

#include <string>
#include <vector>

/// A model without errors, and the errors after a test has changed it.
namespace proskill::fiacre::test {

using Found = std::vector<std::string>;

/// Each error as "place: message".
[[nodiscard]] Found problems(const Program& program);

/// A model without errors, with a bit of everything: two cells, and a worker that it calls.
[[nodiscard]] Program clean();

/// The errors if these statements replace those of the idle worker.
[[nodiscard]] Found whenIdle(std::vector<Statement> statements);

/// The same for an expression in place of a condition.
inline Found guard(Expr expr) { return whenIdle({on(std::move(expr)), to("busy")}); }

inline const std::string kIdle = "process worker, state idle: ";

/// The errors after one change.
template <class Change> Found changed(Change change) {
  auto program = clean();
  change(program);
  return problems(program);
}

[[nodiscard]] Found onProperty(PatternKind kind, std::vector<Observable> operands);

} // namespace proskill::fiacre::test
