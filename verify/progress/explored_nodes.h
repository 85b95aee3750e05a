#pragma once

#include "verify/state/enabled.h"
#include "verify/state/timing.h"
#include "verify/verify.h"

namespace proskill::verify {

/// The nodes of an explored graph, one after the other, wherever they are stored.
class ExploredNodes {
public:
  /// \pre the arguments outlive this
  ExploredNodes(const Enabling& with, Timing& of) : enabling(with), timing(of) {}
  virtual ~ExploredNodes() = default;
  ExploredNodes(const ExploredNodes&) = delete;
  ExploredNodes& operator=(const ExploredNodes&) = delete;

  /// Goes back to before the first node.
  virtual void rewind() = 0;
  /// Moves to the next node that no other one subsumes. \return false at the end
  [[nodiscard]] virtual bool next() = 0;
  /// The number of the current node.
  [[nodiscard]] virtual std::uint64_t node() const = 0;
  /// A number of its state: neighbours with the same number have the same state.
  [[nodiscard]] virtual std::uint64_t state() const = 0;
  [[nodiscard]] virtual SignatureId signature() = 0;
  /// \param to receives the stored words of its state
  virtual void readState(Word* to) const = 0;
  [[nodiscard]] virtual Dbm zone() const = 0;

  /// Forgets what is only kept to save time; signatures may get other numbers.
  virtual void forget() = 0;

  /// What the graph has, and the memory for it.
  [[nodiscard]] virtual Progress progress() const = 0;
  /// Bytes that its tables may allocate at once.
  [[nodiscard]] virtual std::uint64_t growth() const = 0;

  const Enabling& enabling;
  Timing& timing;
};

} // namespace proskill::verify
