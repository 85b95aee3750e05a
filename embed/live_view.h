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
  /// The clock of a run in simulated time that the page may pause.
  [[nodiscard]] std::unique_ptr<runtime::Clock> pausable(std::unique_ptr<runtime::Clock> clock);
  /// The platform of the run, with what the page sends. \pre it outlives this
  [[nodiscard]] runtime::Platform& control(runtime::Platform& platform);
  /// The clock of the run has started.
  void started() { held.tell(0, true); }
  /// The run has ended.
  void finish(const runtime::RunResult& result) { page->finish(result); }

private:
  LiveView() = default;
  Done openPage(Subject subject, const proskill_view_options& options);

  std::string url;
  runtime::Pause held;
  runtime::SignalInbox inbox{held.wakeUp};
  std::unique_ptr<runtime::Platform> controlled;
  std::unique_ptr<view::RunPage> page;
  std::unique_ptr<runtime::Observer> steps; ///< the last member, since it uses the page
};

} // namespace proskill::embed
