#pragma once

#include "disk/growing_file.h"
#include "runtime/control/byte_queue.h"
#include "runtime/control/wake_up.h"

#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

namespace proskill::record {

/// Which time a run takes.
enum class RunTime : std::uint8_t { Real, Simulated };

/// Lets one thread sleep until another has something for it. While nobody sleeps, waking costs the
/// other thread no call of the system.
class Sleeper {
public:
  /// Sleeps until it is woken, unless the condition holds already, or for the given time.
  template <class Condition> void sleep(std::chrono::milliseconds patience, Condition&& isReady) {
    asleep.store(true);
    if (!isReady()) wait(patience);
    asleep.store(false);
    bell.acknowledge();
  }
  void wake() {
    if (asleep.exchange(false)) bell.ring();
  }

private:
  void wait(std::chrono::milliseconds patience) const;

  runtime::WakeUp bell;
  std::atomic<bool> asleep{false};
};

/// Writes a recording in a thread of its own, so that no step waits for the disk, and none takes a
/// lock. What has not been written takes a bounded amount of memory: where the disk does not keep
/// up, a run in simulated time waits for it, and in real time the recording ends.
class Recorder {
public:
  Recorder(disk::GrowingFile to, RunTime time);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder();

  /// What is added first is written at once, so that the file can be read from then on.
  /// \param last the end of the file until more is added; it lives as long as this
  /// \return why the recording has ended, once
  std::optional<std::string> add(std::string_view bytes, std::string_view last);
  /// Overwrites a part of what was added before, after that was written. \return as above
  std::optional<std::string> replace(std::uint64_t at, std::string_view bytes);
  /// Writes the rest. \return why the recording ended early, unless this was reported before
  std::optional<std::string> finish();
  /// Why the recording cannot be found. \pre it is finished
  [[nodiscard]] std::optional<std::string> lost() const { return file.lost(); }

private:
  /// What is to be done with bytes.
  struct Order {
    bool replaces = false;
    std::uint64_t at = 0;  ///< if it replaces
    std::string_view last; ///< if it adds
  };

  std::optional<std::string> begin(std::string_view bytes, std::string_view last);
  std::optional<std::string> put(const Order& order, std::string_view bytes);
  [[nodiscard]] std::optional<std::string> complaint();

  // For the thread that writes.
  void run();
  void rest();
  void writeAll();
  void write();
  [[nodiscard]] std::optional<std::string> addOneByOne();
  void sync();

  disk::GrowingFile file; ///< of the thread alone
  const bool isReal;
  runtime::ByteQueue<Order> queue;
  Sleeper writer;
  Sleeper pause;                       ///< between two writes in real time
  Sleeper adder;                       ///< the run, if it waits for room
  std::atomic<bool> isFinished{false}; ///< nothing is added any more
  std::atomic<bool> isEnded{false};    ///< nothing is written any more
  std::string failure;                 ///< set before `isEnded`
  bool isReported = false;             ///< of the run alone
  std::string writing;                 ///< of the thread alone, as what follows
  std::vector<std::uint32_t> sizes;    ///< of its parts
  std::string_view end;
  bool isSynced = true;
  std::chrono::steady_clock::time_point lastSync;
  std::thread thread;
};

} // namespace proskill::record
