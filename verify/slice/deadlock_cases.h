#pragma once

#include "verify/slice/slicer.h"

#include <optional>
#include <tuple>
#include <vector>

namespace proskill::verify {

/// A condition that concerns a part of the system.
struct PartCase {
  Goal goal;
  Bits loose; ///< see SliceSeeds::loose
};

/// Divides the question whether a system can deadlock into questions about parts of it. While
/// nothing is possible, each instance waits, at one of its locations, for a condition that others
/// have to make true; and those that could do so are blocked, too.
class DeadlockCases {
public:
  /// \pre the argument outlives this
  explicit DeadlockCases(Slicer& slicer);

  /// The instances that may be blocked only while others could unblock them. Those that start by
  /// themselves come first, then those with the fewest conditions. \throw LimitMet
  [[nodiscard]] std::vector<InstanceId> instances();
  /// Conditions of which one is true in each deadlock, found by where this instance may wait;
  /// nothing if one of them concerns almost the whole system. \throw LimitMet
  [[nodiscard]] std::optional<std::vector<PartCase>> casesOf(InstanceId instance);

private:
  using Conditions = std::vector<NodeId>;

  [[nodiscard]] std::optional<Conditions> waitsOf(InstanceId instance);
  [[nodiscard]] std::optional<Conditions> waitsAt(InstanceId instance, std::uint32_t location);
  [[nodiscard]] std::optional<Conditions> waitsOf(TransitionId id, InstanceId instance,
                                                  std::uint32_t location);
  [[nodiscard]] std::optional<PartCase> caseOf(NodeId condition, InstanceId instance);
  [[nodiscard]] std::optional<PartCase> caseWithin(NodeId isFalse, InstanceId instance,
                                                   const Bits& loose);
  [[nodiscard]] bool isExactlyGuarded(TransitionId id) const;
  [[nodiscard]] std::vector<NodeId> blockedSteps(InstanceId of, const Bits& within,
                                                 const Bits& cone, Nodes& nodes);
  [[nodiscard]] Bits writersOf(NodeId condition) const;
  [[nodiscard]] NodeId guardOf(TransitionId id, Nodes& nodes);

  Slicer& slicer;
};

} // namespace proskill::verify
