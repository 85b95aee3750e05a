#pragma once

#include "disk/growing_file.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace proskill::cli {

/// Which time a run takes.
enum class RunTime : std::uint8_t { Real, Simulated };

/// Writes a recording in a thread of its own, so that no step waits for the disk. What has not been
/// written takes a bounded amount of memory: where the disk does not keep up, a run in simulated
/// time waits for it, and in real time the recording ends.
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
  /// Writes the rest. \return why the recording ended early, unless this was reported before
  std::optional<std::string> finish();

private:
  using Lock = std::unique_lock<std::mutex>;

  std::optional<std::string> begin(std::string_view bytes, std::string_view last);
  void run();
  void awaitBytes(Lock& lock);
  void write(Lock& lock);
  /// What fits of that for which there was no room.
  std::optional<std::string> addOneByOne(std::string_view last);
  void sync(Lock& lock);
  void stop(std::string why);
  [[nodiscard]] std::optional<std::string> complaint();

  disk::GrowingFile file; ///< of the thread alone
  const bool isReal;
  std::mutex mutex;
  std::condition_variable hasBytes;
  std::condition_variable hasRoom;
  std::string waiting;
  std::vector<std::uint32_t> sizes; ///< of what was added to it
  std::string_view end;
  bool isFinished = false; ///< nothing is added any more
  bool isEnded = false;    ///< nothing is written any more
  std::optional<std::string> failure;
  std::string writing; ///< of the thread alone, as what follows
  std::vector<std::uint32_t> writingSizes;
  bool isSynced = true;
  std::chrono::steady_clock::time_point lastSync;
  std::thread thread;
};

} // namespace proskill::cli
