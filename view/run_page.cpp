#include "view/run_page.h"

#include "report/run/run_report.h"
#include "view/http_server.h"
#include "view/panel_routes.h"
#include "view/run_panel.h"

#include <fmt/format.h>

#include <thread>

namespace proskill::view {

namespace {

class ServedPage final : public RunPage {
public:
  ServedPage(ObservedRun of, std::unique_ptr<HttpServer> listening)
      : subject{of.program, of.executable},
        panel(std::move(of), news),
        server(std::move(listening)),
        address{server->port(), randomToken()},
        serving([this] { serve(); }) {}
  ServedPage(const ServedPage&) = delete;
  ServedPage& operator=(const ServedPage&) = delete;
  ~ServedPage() override { server->stop(); }

  [[nodiscard]] std::string url() const override { return address.url(); }
  [[nodiscard]] bool takesSignals() const override { return panel.takesSignals(); }
  [[nodiscard]] std::unique_ptr<runtime::Observer> observer() override {
    return report::runLive([this](std::string_view line) { return panel.push(line); }, subject);
  }
  void finish(const runtime::RunResult& result) override { panel.finish(result); }

private:
  void serve() {
    server->serve(
        [this](const HttpRequest& request, const HttpServer::Reply& reply) {
          answer(request, address, panel, news, reply);
        },
        [this] { news.close(); });
  }

  const report::RunSubject subject;
  EventFeed news;
  RunPanel panel;
  std::unique_ptr<HttpServer> server;
  PanelAddress address;
  std::jthread serving; ///< the last member, since it uses the others
};

} // namespace

OpenedPage openRunPage(ObservedRun run, std::uint16_t port) {
  auto server = HttpServer::listen(port);
  if (!server)
    return std::unexpected(fmt::format("cannot listen on port {}: {}", port, server.error()));
  return std::make_unique<ServedPage>(std::move(run), std::move(*server));
}

} // namespace proskill::view
