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

/// The arguments of one start, as the library gets them.
class Arguments {
public:
  explicit Arguments(const nlohmann::ordered_json& list);
  [[nodiscard]] const proskill_value* data() const { return values.data(); }
  [[nodiscard]] std::size_t size() const { return values.size(); }

private:
  std::deque<std::string> texts;
  std::vector<proskill_value> values;
};

/// The runs of actions: which there are, and who is asked to stop. All of it from any thread.
class Runs {
public:
  using OnStop = void(proskill_run, void*);

  /// \param name of the skill; it lives as long as this
  void begin(proskill_run run, const std::string& name);
  /// Ends a run, and waits while its `onStop` is called in another thread. Nothing where there is
  /// none: it has ended before.
  struct Ended {
    bool wasAsked = false;    ///< to stop
    bool isAbandoned = false; ///< nobody wants to hear of it
  };
  [[nodiscard]] std::optional<Ended> end(proskill_run run);

  void askToStop(proskill_run run);
  void abandon(proskill_run run);
  /// Asks all, and waits for their ends. \return the skills of those that did not end in time
  [[nodiscard]] std::vector<std::string> stopAll(std::chrono::nanoseconds patience);

  [[nodiscard]] bool isAsked(proskill_run run) const;
  /// Waits until it is asked to stop or has ended, or for this time. \return whether it was asked
  [[nodiscard]] bool wait(proskill_run run, std::chrono::nanoseconds time) const;
  /// Can be read when it is asked to stop; -1 where there is no such run.
  [[nodiscard]] int descriptor(proskill_run run);
  /// \param call when it is asked to stop; at once where it has been
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
    std::thread::id caller; ///< who calls it now
  };
  using Lock = std::unique_lock<std::mutex>;

  void callOnStop(Lock& lock, proskill_run run);

  mutable std::mutex mutex;
  mutable std::condition_variable changed;
  std::map<proskill_run, Run> all;
};

} // namespace proskill::host
