#pragma once

#include "verify/verify.h"

#include <expected>
#include <string>
#include <vector>

/// Models for other model checkers, made from the transition system that is explored: independent
/// judges of the exploration, of its counts and of its verdicts. docs/bridges/crosscheck.md says
/// what is exact.
namespace proskill::verify {

/// A model as text for another tool.
struct Exported {
  std::string text;
  /// What the text does not say as the model does, or does not ask: one sentence each.
  std::vector<std::string> notes;
};

/// A model for Spin. Without time it has the states and the transitions of the model, one by one.
/// With time it has discrete time: a tick is a step, and clocks stop at their greatest bound. If
/// all bounds are closed, the same discrete states are reachable (Henzinger, Manna, Pnueli, "What
/// good are digital clocks?", ICALP 1992); otherwise perhaps fewer.
/// \param names of the questions
[[nodiscard]] std::expected<Exported, Unsupported>
exportPromela(const fiacre::Program& program, const fiacre::Provenance& provenance,
              const std::vector<Question>& questions, const std::vector<std::string>& names,
              const Options& options = {});

/// A timed automaton for TChecker: a location for each discrete state that can be reached without
/// regard to time.
/// \param names of the questions
/// \param options limits; a model with more than `limits.classes` discrete states is unsupported
[[nodiscard]] std::expected<Exported, Unsupported>
exportTChecker(const fiacre::Program& program, const fiacre::Provenance& provenance,
               const std::vector<Question>& questions, const std::vector<std::string>& names,
               const Options& options = {});

} // namespace proskill::verify
