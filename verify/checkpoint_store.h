#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <string>
#include <string_view>

namespace proskill::verify {

/// Where the state of a verification is kept, so that another process can go on from it. The caller
/// guarantees that a store is used only with its model, its questions, its reductions and the build
/// of the engine that filled it. Limits and the number of threads may differ.
class CheckpointStore {
public:
  /// Receives a piece of the state. \return whether more may follow: false once writing has failed
  using Put = std::function<bool(std::string_view)>;

  CheckpointStore() = default;
  virtual ~CheckpointStore() = default;
  CheckpointStore(const CheckpointStore&) = delete;
  CheckpointStore& operator=(const CheckpointStore&) = delete;

  /// Whether the search is to be interrupted now to save its state. Called very often.
  [[nodiscard]] virtual bool isDue() = 0;
  /// Replaces the state, whole or not at all. \param write passes the new state in pieces
  virtual void replace(const std::function<void(const Put&)>& write) = 0;
  /// Whether there is a state from an earlier process.
  [[nodiscard]] virtual bool hasState() const = 0;
  /// The next piece of that state; empty at its end. The error is a message.
  [[nodiscard]] virtual std::expected<std::string, std::string> next() = 0;
  /// The state was read, and the search goes on with so many classes.
  virtual void resumed(std::uint64_t classes) = 0;
  /// No limit left anything open, so nobody needs the state any more.
  virtual void finished() = 0;
};

} // namespace proskill::verify
