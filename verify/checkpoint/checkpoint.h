#pragma once

#include "verify/checkpoint/reader.h"
#include "verify/checkpoint/writer.h"
#include "verify/limits.h"

#include <functional>
#include <optional>

namespace proskill::verify {

/// The state of a verification that a store keeps: the time it took, what its owner has settled,
/// and the search under way.
class Checkpoint {
public:
  using Write = std::function<void(CheckpointWriter&)>;

  /// Reads the time that earlier processes took.
  /// \pre the arguments outlive this
  Checkpoint(CheckpointStore& of, LimitWatch& watch);

  /// Sets what is written before the search under way. \pre what it refers to outlives this
  void setHead(Write write) { head = std::move(write); }
  /// Replaces the stored state. \param search writes the search under way; may be empty
  void save(const Write& search);
  [[nodiscard]] bool isDue() { return store.isDue(); }

  /// Where to go on reading an earlier state; null if there is none, or it has been read.
  [[nodiscard]] CheckpointReader* earlier() { return reader ? &*reader : nullptr; }
  /// Call this when the earlier state has been read. \return an error message; empty if there is
  /// none
  [[nodiscard]] std::string endEarlier(std::uint64_t classes);
  void finish() { store.finished(); }

private:
  CheckpointStore& store;
  LimitWatch& limits;
  Write head;
  std::optional<CheckpointReader> reader;
};

/// The error if an earlier state cannot be used.
[[nodiscard]] std::string cannotResume(const std::string& message);

} // namespace proskill::verify
