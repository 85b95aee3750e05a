#include "cli/execution/live_view.h"

#include "cli/terminal/browser.h"

#include <iostream>

namespace proskill::cli {

namespace {

std::string whyNoControl(const LiveViewArguments& arguments) {
  return arguments.noControls ? "`--no-controls`: pages cannot influence this run" : "";
}

} // namespace

std::expected<std::unique_ptr<LiveView>, std::string>
LiveView::open(const LiveViewArguments& arguments, Subject subject) {
  std::unique_ptr<LiveView> made(new LiveView(subject, !arguments.noControls));
  if (!made->isReal && made->hasControls) subject.pause.hold();
  auto page = view::openRunPage({.program = subject.program,
                                 .executable = subject.executable,
                                 .pause = subject.pause,
                                 .inbox = made->inbox,
                                 .speed = subject.speed,
                                 .whyNoControl = whyNoControl(arguments),
                                 .whyNoPause = std::move(subject.whyNoPause),
                                 .askToEnd = std::move(subject.askToEnd)},
                                arguments.port);
  if (!page) return std::unexpected(std::move(page.error()));
  made->page = std::move(*page);
  std::cerr << "the run is shown at " << made->url() << std::endl;
  if (!arguments.noOpen) openBrowser(made->url());
  return made;
}

bool LiveView::waitsForPage() const { return isReal && hasControls && page->takesSignals(); }

} // namespace proskill::cli
