#pragma once

#include "tests/fiacre/build.h"
#include "verify/verify.h"

#include <string>
#include <vector>

/// Small models for the tests of verify/: processes by hand, one component around them, questions.
namespace proskill::test {

using namespace proskill::fiacre::test; // NOLINT: the words of a small language for tests

inline fiacre::Statement waitIn(fiacre::Interval interval) {
  return {.kind = fiacre::StatementKind::Wait, .interval = interval};
}
inline fiacre::Statement always() { return wait(0, std::nullopt); }
inline fiacre::Statement now() { return wait(0, 0); }
inline fiacre::Statement loop() { return {.kind = fiacre::StatementKind::Loop}; }
inline fiacre::Expr equals(fiacre::Expr a, fiacre::Expr b) {
  return binary(fiacre::Op::Equal, std::move(a), std::move(b));
}
inline fiacre::Expr sum(fiacre::Expr a, fiacre::Expr b) {
  return binary(fiacre::Op::Add, std::move(a), std::move(b));
}

/// Which properties a model is asked, as short words.
fiacre::Property absentState(std::uint32_t place, std::string state);
fiacre::Property absentTag(std::uint32_t place, std::string name);
fiacre::Property absentValue(fiacre::Expr value);
fiacre::Property plain(fiacre::PatternKind kind);

/// A model under construction: shared variables, ports and instances of processes.
class Model {
public:
  Model& variable(std::string name, fiacre::Type type, fiacre::Expr init);
  Model& channel(std::string name, std::optional<fiacre::Interval> interval = {});
  /// A process and its only instance. It gets every shared variable and every port, by the same
  /// names.
  Model& add(fiacre::Process process);
  Model& ask(fiacre::Property property);

  [[nodiscard]] const fiacre::Program& program() const { return made; }
  [[nodiscard]] fiacre::Program& program() { return made; }
  /// The answers to all that was asked.
  [[nodiscard]] verify::Result answers(const verify::Options& options = {}) const;
  /// The answer to one more question.
  [[nodiscard]] verify::Answer answer(fiacre::Property property,
                                      const verify::Options& options = {}) const;
  /// Whether the state of an instance (from 1) is reachable. \pre not unknown
  [[nodiscard]] bool reaches(std::uint32_t place, std::string state) const;
  [[nodiscard]] bool stops() const { return isFalse(plain(fiacre::PatternKind::DeadlockFree)); }
  [[nodiscard]] bool isFalse(fiacre::Property property) const;

private:
  fiacre::Program made{.components = {{.name = "main"}}, .main = "main"};
};

/// Every set of reductions that a test should try: all, none, each one alone, all but each one.
std::vector<verify::Options> reductionChoices();

} // namespace proskill::test
