#pragma once

#include "embed/audience.h"
#include "embed/entries.h"
#include "embed/function_platform.h"
#include "embed/live_view.h"
#include "embed/named_platform.h"
#include "embed/shared_platform.h"
#include "record/run_recording.h"
#include "runtime/executor/execution.h"

#include <atomic>
#include <memory>
#include <string>

/// What programs in C see as proskill_executor: one run of a program.
struct proskill_executor {
public:
  using Done = proskill::embed::Done;
  using Failure = proskill::embed::Failure;
  using Nanoseconds = proskill::runtime::Nanoseconds;

  /// \param options null: the default
  [[nodiscard]] static std::expected<std::unique_ptr<proskill_executor>, Failure>
  make(const proskill_program& program, const proskill_options* options);
  proskill_executor(const proskill_executor&) = delete;
  proskill_executor& operator=(const proskill_executor&) = delete;
  ~proskill_executor();

  Done perform(const char* skill, proskill::embed::Functions functions);
  Done observe(proskill_observer observer, void* data);
  /// \param file of a new recording
  Done record(const char* file);
  /// \param options null: the default
  Done serveView(const proskill_view_options* options);
  Done start();
  /// Does what is due. \pre `exclusively`
  Done proceed();
  /// Proceeds until the end. \pre `exclusively`
  Done runToEnd();

  /// Makes a call that only one thread may make at a time, and none of the functions that the
  /// executor calls.
  template <class Call> Done exclusively(Call&& call);

  [[nodiscard]] proskill_phase phase() const;
  [[nodiscard]] proskill_end end() const;
  [[nodiscard]] const char* outcome() const;
  /// Seconds until the run should proceed; negative: when the descriptor is readable.
  [[nodiscard]] double timeout();
  [[nodiscard]] Nanoseconds date() const { return execution ? execution->now() : 0; }
  /// Why the recording ended early; empty if it did not.
  [[nodiscard]] const std::string& recordingError() const { return lacking; }
  /// Empty: there is no page.
  [[nodiscard]] const std::string& viewAddress() const;
  [[nodiscard]] std::uint64_t steps() const;
  [[nodiscard]] std::uint64_t faults() const;
  /// The text lives until the next call.
  [[nodiscard]] std::expected<const char*, Failure> value(std::string_view name);
  [[nodiscard]] const char* nameOfValue(std::size_t index) const;
  [[nodiscard]] int descriptor() const { return shared.descriptor(); }

  // For any thread
  /// Fails before the start of the run.
  [[nodiscard]] std::expected<proskill::embed::FunctionPlatform*, Failure> started() const;
  [[nodiscard]] bool isAsked(proskill::runtime::RunNumber run) const {
    return platform->isAsked(run);
  }
  /// Async-signal-safe.
  void stop();

private:
  struct Settings {
    proskill::runtime::RunOptions run;
    double speed = 1;
    bool isReal = true;
  };
  proskill_executor(std::shared_ptr<const proskill::analysis::Program> program,
                    std::unique_ptr<const proskill::runtime::Executable> executable,
                    const Settings& settings,
                    std::optional<proskill::embed::NamedPlatform> platform);
  [[nodiscard]] static std::expected<Settings, Failure> settingsOf(const proskill_options& options);
  [[nodiscard]] Done notStarted() const;
  Done openPlatform();
  [[nodiscard]] proskill::runtime::Platform& controlledPlatform();
  void beginRecording();
  void endRun();
  bool doWhatIsDue();
  bool jump();
  void wait();

  std::shared_ptr<const proskill::analysis::Program> program;
  std::unique_ptr<const proskill::runtime::Executable> executable;
  Settings settings;
  std::atomic<int> stopRequests = 0;
  std::atomic<bool> isBusy = false;
  std::atomic<bool> hasStarted = false;
  bool hasEnded = false;
  std::unique_ptr<proskill::runtime::Clock> clock;
  std::unique_ptr<proskill::embed::FunctionPlatform> platform;
  proskill::embed::SharedPlatform shared;
  std::optional<proskill::embed::NamedPlatform> named; ///< performs what no function performs
  proskill::embed::Entries entries;
  std::string recordedIn;                          ///< the name of the file
  std::optional<proskill::disk::GrowingFile> file; ///< of the recording, before the start
  std::string lacking;
  std::unique_ptr<proskill::record::RunRecording> recording; ///< may be null
  std::unique_ptr<proskill::embed::LiveView> live;           ///< may be null
  proskill::embed::Audience audience{entries};
  std::unique_ptr<proskill::runtime::Execution> execution; ///< null before the start
  std::string shown;                                       ///< the value that was asked for last
};

template <class Call> proskill_executor::Done proskill_executor::exclusively(Call&& call) {
  if (isBusy.exchange(true))
    return proskill::embed::failed(
        PROSKILL_WRONG_ORDER,
        "the executor is in use: by another thread, or because it has called this function");
  struct Release {
    std::atomic<bool>& busy;
    ~Release() { busy = false; }
  } const release{isBusy};
  return call();
}
