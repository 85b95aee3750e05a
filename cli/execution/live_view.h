#pragma once

#include "view/run_page.h"

namespace proskill::cli {

/// `--view` and what belongs to it.
struct LiveViewArguments {
  bool isOn = false;
  bool noOpen = false;
  bool noControls = false;
  bool controls = false; ///< also of a run in real time
  std::uint16_t port = 0;
};

/// The page of a run, and what it does to the run.
class LiveView {
public:
  /// What the page shows.
  struct Subject {
    const analysis::Program& program;
    const runtime::Executable& executable;
    std::optional<double> speed; ///< of a real clock
    std::string whyNoPause;      ///< empty: the page may pause it
    runtime::Pause& pause;
    std::function<void()> askToEnd;
  };

  /// Prints the address, and opens a browser. The error is a message.
  [[nodiscard]] static std::expected<std::unique_ptr<LiveView>, std::string>
  open(const LiveViewArguments& arguments, Subject subject);
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  runtime::SignalInbox inbox;

  /// Whether a run in which nothing can happen waits for what the page sends.
  [[nodiscard]] bool waitsForPage() const;
  [[nodiscard]] std::unique_ptr<runtime::Observer> observer() { return page->observer(); }
  /// The run has ended: the page shows it until this is destroyed.
  void finish(const runtime::RunResult& result) { page->finish(result); }
  [[nodiscard]] std::string url() const { return page->url(); }

private:
  LiveView(const Subject& subject, bool hasControls)
      : inbox(subject.pause.wakeUp), isReal(subject.speed), hasControls(hasControls) {}

  const bool isReal;
  const bool hasControls;
  std::unique_ptr<view::RunPage> page; ///< the last member, since it uses the others
};

} // namespace proskill::cli
