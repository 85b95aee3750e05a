#pragma once

#include "tests/fiacre/build.h"
#include "verify/verify.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

/// Small models for the tests of verify/: hand-written processes, one component around them,
/// questions.
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

/// Names of the properties of a model.
fiacre::Property absentState(std::uint32_t place, std::string state);
fiacre::Property absentTag(std::uint32_t place, std::string name);
fiacre::Property absentValue(fiacre::Expr value);
fiacre::Property plain(fiacre::PatternKind kind);

/// A model under construction: shared variables, ports and instances of processes.
class Model {
public:
  Model& variable(std::string name, fiacre::Type type, fiacre::Expr init);
  Model& channel(std::string name, std::optional<fiacre::Interval> interval = {});
  /// Adds a process and its only instance, which receives every shared variable and every port by
  /// the same names.
  Model& add(fiacre::Process process);
  Model& ask(fiacre::Property property);

  [[nodiscard]] const fiacre::Program& program() const { return made; }
  [[nodiscard]] fiacre::Program& program() { return made; }
  /// The answers to all questions.
  [[nodiscard]] verify::Result answers(const verify::Options& options = {}) const;
  /// The answer to one more question.
  [[nodiscard]] verify::Answer answer(fiacre::Property property,
                                      const verify::Options& options = {}) const;
  /// Whether the state of an instance (from 1) is reachable. \pre it is decided
  [[nodiscard]] bool reaches(std::uint32_t place, std::string state) const;
  [[nodiscard]] bool stops() const { return isFalse(plain(fiacre::PatternKind::DeadlockFree)); }
  [[nodiscard]] bool isFalse(fiacre::Property property) const;

private:
  fiacre::Program made{.components = {{.name = "main"}}, .main = "main"};
};

/// Sets of reductions to test: all, none, each one alone, all but each one.
std::vector<verify::Options> reductionChoices();

/// The number of classes with which a true property of a model is decided.
std::uint64_t classesToProve(Model model, fiacre::Property property,
                             std::set<verify::Reduction> reductions);

} // namespace proskill::test
