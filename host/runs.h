#pragma once

#include "include/proskill/platform.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace proskill::host {

/// Arguments of an action, as the library receives them.
class Arguments {
public:
  explicit Arguments(const nlohmann::ordered_json& list);
  [[nodiscard]] const proskill_value* data() const { return values.data(); }
  [[nodiscard]] std::size_t size() const { return values.size(); }

private:
  std::deque<std::string> texts;
  std::vector<proskill_value> values;
};

/// Running actions and their stop requests. Thread-safe.
class Runs {
public:
  using OnStop = void(proskill_run, void*);

  /// \param name of the skill; it must outlive this object
  void begin(proskill_run run, const std::string& name);
  /// Ends a run; first waits for its `onStop` callback if another thread is in it.
  /// \return nullopt if the run has already ended
  struct Ended {
    bool wasAsked = false;    ///< was asked to stop
    bool isAbandoned = false; ///< its end is not to be reported
  };
  [[nodiscard]] std::optional<Ended> end(proskill_run run);

  void askToStop(proskill_run run);
  void abandon(proskill_run run);
  /// Asks all runs to stop and waits for their ends.
  /// \return the skills whose actions did not end in time
  [[nodiscard]] std::vector<std::string> stopAll(std::chrono::nanoseconds patience);

  [[nodiscard]] bool isAsked(proskill_run run) const;
  /// Waits until the run is asked to stop, ends, or this time has passed.
  /// \return whether it was asked to stop
  [[nodiscard]] bool wait(proskill_run run, std::chrono::nanoseconds time) const;
  /// File descriptor that becomes readable when the run is asked to stop; -1 if there is no such
  /// run.
  [[nodiscard]] int descriptor(proskill_run run);
  /// \param call called when the run is asked to stop; at once if it already was
  void onStop(proskill_run run, OnStop* call, void* data);
  [[nodiscard]] const char* skill(proskill_run run) const;

private:
  struct Run {
    const std::string* skill = nullptr;
    bool isAsked = false;
    bool isAbandoned = false;
    int descriptor = -1;
    OnStop* onStop = nullptr;
    void* data = nullptr;
    std::thread::id caller; ///< thread that is in the callback
  };
  using Lock = std::unique_lock<std::mutex>;

  void callOnStop(Lock& lock, proskill_run run);

  mutable std::mutex mutex;
  mutable std::condition_variable changed;
  std::map<proskill_run, Run> all;
};

} // namespace proskill::host
