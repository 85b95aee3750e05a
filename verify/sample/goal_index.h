#pragma once

#include "verify/model/goals.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace proskill::verify {

/// Finds the goals that a step reaches. A condition is evaluated only after a step that writes what
/// it reads, or has an event that it reads.
class GoalIndex {
public:
  /// \param which those to look for, by index \pre the arguments outlive this
  GoalIndex(const System& of, const std::vector<Goal>& all, const std::vector<std::size_t>& which);

  /// Whether a run can reach it step by step.
  [[nodiscard]] static bool isFor(const Goal& goal);

  /// The goals that are reached by a step.
  /// \param before, after the states around it
  /// \param isEnd whether nothing is possible after it
  /// \return by index; valid until the next call
  [[nodiscard]] const std::vector<std::size_t>& reached(TransitionId step, const Word* before,
                                                        const Word* after,
                                                        const std::vector<EventId>& events,
                                                        bool isEnd);
  /// The goals that ask for errors, by index.
  [[nodiscard]] const std::vector<std::size_t>& errors() const { return ofErrors; }
  /// Does not look for it any more.
  void remove(std::size_t goal);
  [[nodiscard]] bool empty() const { return left == 0; }

private:
  void add(std::size_t goal);
  [[nodiscard]] const std::vector<std::size_t>& conditionsAfter(TransitionId step);
  void look(std::span<const std::size_t> among, const Word* before, const Word* after,
            const Bits& events);

  const System& system;
  const std::vector<Goal>& goals;
  std::vector<bool> wanted;                      ///< by goal
  std::size_t left = 0;                          ///< number of those wanted
  std::vector<std::vector<std::size_t>> byEvent; ///< goals that ask for it, or read it
  std::vector<std::vector<std::size_t>> byCell;  ///< conditions that read it
  std::vector<std::size_t> ofEnds;
  std::vector<std::size_t> ofErrors;
  /// By step that was taken: the conditions that read what it writes.
  std::vector<std::optional<std::vector<std::size_t>>> byStep;
  std::vector<std::size_t> found;
};

} // namespace proskill::verify
