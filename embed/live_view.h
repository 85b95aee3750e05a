#pragma once

#include "embed/failure.h"
#include "view/run_page.h"

#include <memory>
#include <string>

namespace proskill::embed {

/// The page that shows a run, of the library that is loaded for it, and what the page does to the
/// run.
class LiveView {
public:
  /// What the page shows. \pre the references outlive it
  struct Subject {
    const analysis::Program& program;
    const runtime::Executable& executable;
    std::optional<double> speed; ///< of a real clock
    std::string whoGoesOn;       ///< why nobody can pause it in real time; empty: the program may
    std::function<void()> askToEnd;
  };

  /// \param options null: the default
  [[nodiscard]] static std::expected<std::unique_ptr<LiveView>, Failure>
  open(Subject subject, const proskill_view_options* options);
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  [[nodiscard]] const std::string& address() const { return url; }
  [[nodiscard]] runtime::Pause& pause() { return held; }
  /// Rings when the page pauses or continues the run, or sends something.
  [[nodiscard]] runtime::WakeUp& wakeUp() { return held.wakeUp; }
  [[nodiscard]] runtime::Observer& observer() { return *steps; }
  /// Whether the page may pause the run.
  [[nodiscard]] bool canPause() const { return isPausable; }
  /// The run's: calls the program's function if the page has paused or continued the run in real
  /// time.
  [[nodiscard]] Done tellHold(proskill_executor* executor);
  /// The clock of a run that the page may pause.
  [[nodiscard]] std::unique_ptr<runtime::Clock> pausable(std::unique_ptr<runtime::Clock> clock);
  /// The platform of the run, with what the page sends. \pre it outlives this
  [[nodiscard]] runtime::Platform& control(runtime::Platform& platform);
  /// The clock of the run has started.
  void started() { held.tell(0, true); }
  /// The run has ended.
  void finish(const runtime::RunResult& result) { page->finish(result); }

private:
  LiveView() = default;
  /// The function of the program that holds its actions.
  struct Holder {
    proskill_hold function = nullptr; ///< null: it is not called
    void* data = nullptr;
    bool isTold = false; ///< that the run is paused
  };
  Done openPage(Subject subject, const proskill_view_options& options);

  std::string url;
  bool isPausable = false;
  Holder holder;
  runtime::Pause held;
  runtime::SignalInbox inbox{held.wakeUp};
  std::unique_ptr<runtime::Platform> controlled;
  std::unique_ptr<view::RunPage> page;
  std::unique_ptr<runtime::Observer> steps; ///< the last member, since it uses the page
};

} // namespace proskill::embed
