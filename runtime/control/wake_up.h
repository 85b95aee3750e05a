#pragma once

#include <atomic>

namespace proskill::runtime {

/// Wakes a run that waits for descriptors. Reading it costs nothing while nobody has used it.
class WakeUp {
public:
  WakeUp();
  WakeUp(const WakeUp&) = delete;
  WakeUp& operator=(const WakeUp&) = delete;
  ~WakeUp();

  /// From any thread.
  void ring();
  /// For the run: makes the descriptor unreadable until the next ring.
  void acknowledge();
  [[nodiscard]] int descriptor() const { return file; }

private:
  int file;
  std::atomic<bool> rang{false};
};

} // namespace proskill::runtime
