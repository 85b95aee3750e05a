#pragma once

#include "verify/explore/search.h"
#include "verify/model/goals.h"
#include "verify/reduce/free_inputs.h"
#include "verify/trace/dates.h"
#include "verify/trace/replay.h"

#include <optional>
#include <vector>

namespace proskill::verify {

/// Makes a trace of evidence: on the system with nothing reduced, with dates, replayed.
class Witness {
public:
  /// \param whole the system with every cell kept \param reductions those that the search used
  /// \pre the arguments outlive this
  Witness(const System& whole, const Reductions& reductions, const fiacre::Provenance& provenance,
          LimitWatch& limits);

  /// What a search has found as steps of the whole system, as few as will do. \throw LimitMet
  [[nodiscard]] Evidence tidied(const Goal& goal, const Evidence& evidence) const;
  /// Replays such steps. \return why they do not stand; empty where they do. \throw LimitMet
  [[nodiscard]] std::string refutation(const Goal& goal, const Evidence& evidence) const;
  /// The trace of such steps, or why they do not stand. \throw LimitMet
  [[nodiscard]] std::expected<Trace, std::string> trace(const Goal& goal,
                                                        const Evidence& evidence) const;

private:
  [[nodiscard]] std::string check(const Goal& goal, const Evidence& evidence,
                                  std::optional<Dating>& dating) const;
  void addCauses(const Goal& goal, const Evidence& evidence, Trace& trace) const;
  [[nodiscard]] const std::vector<std::uint32_t>& watchedBy(TransitionId step) const;
  [[nodiscard]] Evidence lazily(const Goal& goal, const Evidence& evidence) const;
  [[nodiscard]] Evidence completed(const Goal& goal, const Evidence& evidence) const;

  const System& system;
  Enabling enabling; ///< of what the search looked at
  Enabling all;
  TransitionSet dropped;          ///< what the search did not look at
  std::optional<FreeInputs> open; ///< as the search used them
  const fiacre::Provenance& provenance;
  LimitWatch& limits;
  mutable ReplayedRun played; ///< traces of one search mostly begin alike
  /// By transition that a trace had: the watched cells that it may change.
  mutable std::vector<std::optional<std::vector<std::uint32_t>>> changing;
};

} // namespace proskill::verify
