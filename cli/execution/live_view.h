#pragma once

#include "runtime/control/pause.h"
#include "runtime/control/signal_inbox.h"
#include "view/http_server.h"
#include "view/panel_routes.h"
#include "view/run_panel.h"

#include <thread>

namespace proskill::cli {

/// `--view` and what belongs to it.
struct LiveViewArguments {
  bool isOn = false;
  bool noOpen = false;
  bool noControls = false;
  bool controls = false; ///< also of a run in real time
  std::uint16_t port = 0;
};

/// The page of a run, served by threads of its own.
class LiveView {
public:
  /// What the page shows.
  struct Subject {
    const analysis::Program& program;
    const runtime::Executable& executable;
    std::optional<double> speed; ///< of a real clock
    bool isSimulation = true;    ///< the platform is simulated
    std::function<void()> askToEnd;
  };

  /// Prints the address, and opens a browser. The error is a message.
  [[nodiscard]] static std::expected<std::unique_ptr<LiveView>, std::string>
  open(const LiveViewArguments& arguments, Subject subject);
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;
  ~LiveView();

  runtime::Pause pause;
  runtime::SignalInbox inbox{pause.wakeUp};

  /// Whether a run in which nothing can happen waits for what the page sends.
  [[nodiscard]] bool waitsForPage() const;
  [[nodiscard]] std::unique_ptr<runtime::Observer> observer();
  /// The run has ended: the page shows it until this is destroyed.
  void finish(const runtime::RunResult& result) { panel.finish(result); }
  [[nodiscard]] std::string url() const { return address.url(); }

private:
  LiveView(const LiveViewArguments& arguments, Subject of,
           std::unique_ptr<view::HttpServer> listening);

  const Subject subject;
  const bool hasControls;
  view::EventFeed news;
  view::RunPanel panel;
  std::unique_ptr<view::HttpServer> server;
  view::PanelAddress address;
  std::jthread serving; ///< the last member, since it uses the others
};

} // namespace proskill::cli
