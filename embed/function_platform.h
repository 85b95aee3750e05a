#pragma once

#include "embed/failure.h"
#include "runtime/clock/clock.h"
#include "runtime/control/pause.h"
#include "runtime/platform/platform.h"

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

namespace proskill::embed {

/// Who performs the action of a basic skill.
struct Functions {
  proskill_begin begin = nullptr;
  proskill_stop stop = nullptr; ///< may be null
  void* data = nullptr;
};

/// Has functions of another program perform the actions. They are called in the thread of the run;
/// what they report may come from any thread.
class FunctionPlatform final : public runtime::Platform {
public:
  /// \param owner is passed to the functions \pre the arguments outlive this
  FunctionPlatform(const runtime::Executable& executable, runtime::Clock& clock,
                   proskill_executor* owner);

  /// Times are those of a clock that is paused. \pre the pause outlives this
  /// \param speed seconds of the run per second
  void timesFrom(const runtime::Pause& of, double speed) {
    pause = &of;
    speedOfPause = speed;
  }
  void perform(std::uint32_t action, Functions functions) { performers[action] = functions; }
  [[nodiscard]] bool performs(std::uint32_t action) const {
    return performers[action].begin != nullptr;
  }
  [[nodiscard]] bool performsAny() const;
  /// The skills whose actions it performs.
  [[nodiscard]] std::vector<std::string> performed() const;
  /// The first basic skill without functions; nullopt: none.
  [[nodiscard]] std::optional<std::uint32_t> unperformed() const;
  runtime::WakeUp wakeUp; ///< rings when there is a report

  // For any thread. Delays are times of the run's clock.
  /// \param result null: the action has stopped
  Done finish(runtime::RunNumber run, const char* result, runtime::Nanoseconds delay);
  Done fail(runtime::RunNumber run, std::string_view why);
  /// \param interrupts whether `name` is that of a skill, and not of an event
  Done send(std::string_view name, bool interrupts, runtime::Nanoseconds delay);
  void log(std::string text);
  /// Whether a run is to stop, or has ended.
  [[nodiscard]] bool isAsked(runtime::RunNumber run) const;

  // For the run
  void start(const runtime::Start& start, runtime::Nanoseconds date) override;
  bool stop(std::uint32_t action, runtime::RunNumber run, runtime::Nanoseconds date) override;
  void abandon(std::uint32_t action, runtime::RunNumber run, runtime::Nanoseconds date) override;
  [[nodiscard]] std::optional<runtime::Nanoseconds> next() const override;
  bool poll(runtime::Nanoseconds date, runtime::Report& report) override;
  [[nodiscard]] bool mayReport() const override;
  void close() override;
  void addDescriptors(std::vector<int>& all) const override;

private:
  struct Run {
    runtime::RunNumber number = 0;
    bool isRunning = false;
    bool isAsked = false;
  };

  [[nodiscard]] std::expected<std::optional<std::uint32_t>, Failure>
  actionOf(runtime::RunNumber run) const;
  Done setResult(runtime::Report& report, const char* result) const;
  void plan(runtime::Report report, runtime::Nanoseconds delay);
  [[nodiscard]] runtime::Nanoseconds now() const;
  bool counts(runtime::Report& report);
  void end(std::uint32_t action);
  template <class Call> void guarded(runtime::RunNumber run, Call&& call);

  const runtime::Executable& executable;
  runtime::Clock& clock;
  proskill_executor* owner;
  const runtime::Pause* pause = nullptr; ///< null: the clock is never paused
  double speedOfPause = 1;
  std::vector<Functions> performers;          ///< by action
  std::atomic<runtime::Nanoseconds> seen = 0; ///< the last date of the run
  mutable std::mutex mutex;                   ///< guards what follows
  std::vector<Run> runs;                      ///< by action: the latest one
  runtime::RunNumber lastRun = 0;
  bool hasClosed = false; ///< nobody hears of anything any more
  std::multimap<runtime::Nanoseconds, runtime::Report> planned; ///< at 0: at once
};

} // namespace proskill::embed
