#pragma once

#include "verify/goals.h"
#include "verify/search.h"

namespace proskill::verify {

/// Makes a trace of evidence: on the system with nothing reduced, with dates, replayed.
class Witness {
public:
  /// \param whole the system with every cell kept \param dropped transitions that the search left
  /// out
  Witness(const System& whole, const Bits& dropped, const fiacre::Provenance& provenance);

  /// The trace, or why the evidence does not stand: a mistake of the engine.
  [[nodiscard]] std::expected<Trace, std::string> trace(const Goal& goal, Evidence evidence) const;

private:
  [[nodiscard]] std::vector<TransitionId> completed(const Goal& goal,
                                                    const std::vector<TransitionId>& steps) const;
  [[nodiscard]] std::string nameOf(TransitionId transition, const StepLog& log) const;
  [[nodiscard]] std::vector<fiacre::OriginId> tellingLast(const StepLog& log) const;
  [[nodiscard]] std::vector<Change> changes(const std::vector<Word>& before,
                                            const std::vector<Word>& after) const;

  const System& system;
  const Bits& dropped;
  const fiacre::Provenance& provenance;
};

} // namespace proskill::verify
