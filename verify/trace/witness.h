#pragma once

#include "verify/explore/search.h"
#include "verify/model/goals.h"
#include "verify/reduce/free_inputs.h"
#include "verify/trace/dates.h"
#include "verify/trace/replay.h"

#include <optional>
#include <vector>

namespace proskill::verify {

/// Turns evidence into a trace: a dated and replayed run of the system without reductions.
class Witness {
public:
  /// \param whole the system with all cells kept
  /// \param reductions the reductions that the search used
  /// \pre the arguments outlive this
  Witness(const System& whole, const Reductions& reductions, const fiacre::Provenance& provenance,
          LimitWatch& limits);

  /// Of all transitions. \throw LimitMet
  [[nodiscard]] const Enabling& enablingOfAll() const;
  /// The evidence of a search as steps of the whole system, with as few steps as possible. \throw
  /// LimitMet
  [[nodiscard]] Evidence tidied(const Goal& goal, const Evidence& evidence) const;
  /// Dates of the steps, if they have any. \throw LimitMet
  [[nodiscard]] std::optional<Dating> dates(const Evidence& evidence) const;
  /// Replays these steps. \return why the replay fails, or an empty string
  /// \throw LimitMet
  [[nodiscard]] std::string refutation(const Goal& goal, const Evidence& evidence) const;
  /// Replays these steps. \return the answer that they show, or why they show none
  /// \throw LimitMet
  [[nodiscard]] std::expected<Answer, std::string>
  answer(const Goal& goal, const Evidence& evidence, bool wantsTrace) const;
  /// The trace of these steps, or why the replay fails. \throw LimitMet
  [[nodiscard]] std::expected<Trace, std::string> trace(const Goal& goal,
                                                        const Evidence& evidence) const;

private:
  [[nodiscard]] std::string check(const Goal& goal, const Evidence& evidence,
                                  std::optional<Dating>& dating, bool windows) const;
  void reserveSteps(Trace& made, std::size_t count) const;
  void addCauses(const Goal& goal, const Evidence& evidence, Trace& trace) const;
  [[nodiscard]] const std::vector<std::uint32_t>& watchedBy(TransitionId step) const;
  [[nodiscard]] Evidence lazily(const Goal& goal, const Evidence& evidence) const;
  [[nodiscard]] Evidence completed(const Goal& goal, const Evidence& evidence) const;
  /// As the search computed it. \throw LimitMet
  [[nodiscard]] const Enabling& enablingOfSearch() const;
  [[nodiscard]] const Enabling& madeOnce(std::optional<Enabling>& tables,
                                         const Bits& without) const;

  const System& system;
  Bits dropped; ///< transitions that the search skipped
  // They are large, and most searches find nothing to show.
  mutable std::optional<Enabling> wholeTables;
  mutable std::optional<Enabling> searchedTables;
  std::optional<FreeInputs> open; ///< the free inputs that the search used
  const fiacre::Provenance& provenance;
  LimitWatch& limits;
  mutable ReplayedRun played; ///< the traces of one search usually start with the same steps
  /// By transition that occurred in a trace: the watched cells that it may change.
  mutable std::vector<std::optional<std::vector<std::uint32_t>>> changing;
};

} // namespace proskill::verify
