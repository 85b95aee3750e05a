#pragma once

#include "verify/slice/slicer.h"

#include <string>
#include <vector>

namespace proskill::verify {

/// Everything on which it depends what happens in a slice, as bytes. Cells, expressions, events,
/// instances and clocks are numbered in the order of their use, and nothing has a name. So slices
/// of different models have the same bytes if they do the same.
class PartText {
public:
  /// \pre the argument outlives this
  explicit PartText(const System& slice);

  /// The slice and a question about it.
  [[nodiscard]] std::string with(const Goal& goal) const;

private:
  struct Numbers {
    std::vector<std::uint32_t> of; ///< kNone: not used yet
    std::uint32_t count = 0;
  };

  void put(std::int64_t number);
  void put(const fiacre::Interval& interval);
  /// Writes the number. \return whether it is new
  bool putNumber(Numbers& numbers, std::uint32_t id);
  void putCell(CellId id);
  void putNode(NodeId id);
  void putEvent(EventId id);
  void putInstance(InstanceId id);
  void putClock(ClockId id);
  void putPath(PathId id);
  void putContent(const Path& path);
  void putCode(const Path& path);
  void putTransition(const Transition& transition);
  void putGoal(const Goal& goal);
  void putMonitor(const Monitor& monitor);

  const System& system;
  Numbers cells;
  Numbers nodes;
  Numbers events;
  Numbers instances;
  Numbers clocks;
  Numbers paths;
  std::string bytes;
};

} // namespace proskill::verify
