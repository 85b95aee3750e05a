#include "cli/execution/live_view.h"

#include "cli/terminal/browser.h"
#include "report/run/run_report.h"

#include <iostream>

namespace proskill::cli {

namespace {

std::string whyNoControl(const LiveViewArguments& arguments) {
  return arguments.noControls ? "`--no-controls`: pages cannot influence this run" : "";
}

/// A robot cannot be stopped in the middle of a movement, as a simulation can.
std::string whyNoPause(const LiveView::Subject& subject) {
  return subject.isSimulation ? "" : "only simulations can be paused: the robot would go on";
}

} // namespace

std::expected<std::unique_ptr<LiveView>, std::string>
LiveView::open(const LiveViewArguments& arguments, Subject subject) {
  auto server = view::HttpServer::listen(arguments.port);
  if (!server) return std::unexpected("cannot listen on the port: " + server.error());
  std::unique_ptr<LiveView> made(new LiveView(arguments, std::move(subject), std::move(*server)));
  std::cerr << "the run is shown at " << made->url() << std::endl;
  if (!arguments.noOpen) openBrowser(made->url());
  return made;
}

LiveView::LiveView(const LiveViewArguments& arguments, Subject of,
                   std::unique_ptr<view::HttpServer> listening)
    : subject(std::move(of)),
      hasControls(!arguments.noControls),
      panel({subject.program, subject.executable, pause, inbox, subject.speed,
             whyNoControl(arguments), whyNoPause(subject), subject.askToEnd},
            news),
      server(std::move(listening)),
      address{server->port(), view::randomToken()},
      serving([this] {
        server->serve(
            [this](const view::HttpRequest& request, const view::HttpServer::Reply& reply) {
              answer(request, address, panel, news, reply);
            },
            [this] { news.close(); });
      }) {
  if (!subject.speed && hasControls) pause.hold();
}

LiveView::~LiveView() { server->stop(); }

bool LiveView::waitsForPage() const { return subject.speed && hasControls && panel.takesSignals(); }

std::unique_ptr<runtime::Observer> LiveView::observer() {
  return report::runLive([this](std::string_view line) { return panel.push(line); },
                         {subject.program, subject.executable});
}

} // namespace proskill::cli
