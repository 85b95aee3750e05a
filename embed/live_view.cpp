#include "embed/live_view.h"

#include "embed/page_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace proskill::embed {

namespace {

std::expected<proskill_view_options, Failure> completed(const proskill_view_options* given) {
  proskill_view_options options = PROSKILL_VIEW_OPTIONS;
  if (!given) return options;
  if (given->size < sizeof options)
    return failed(PROSKILL_INVALID_ARGUMENT, "options must begin as PROSKILL_VIEW_OPTIONS");
  std::memcpy(&options, given, sizeof options);
  return options;
}

Done suits(const proskill_view_options& options, bool isReal) {
  if (!options.paused) return {};
  if (isReal)
    return failed(PROSKILL_INVALID_ARGUMENT, "only a run in simulated time can begin `paused`");
  if (options.no_controls)
    return failed(PROSKILL_INVALID_ARGUMENT,
                  "`paused` and `no_controls` exclude each other: nobody could continue the run");
  return {};
}

} // namespace

std::expected<std::unique_ptr<LiveView>, Failure>
LiveView::open(Subject subject, const proskill_view_options* given) {
  const auto options = completed(given);
  if (!options) return std::unexpected(options.error());
  if (auto done = suits(*options, subject.speed.has_value()); !done)
    return std::unexpected(std::move(done.error()));
  std::unique_ptr<LiveView> made(new LiveView);
  if (auto done = made->openPage(std::move(subject), *options); !done)
    return std::unexpected(std::move(done.error()));
  return made;
}

Done LiveView::openPage(Subject subject, const proskill_view_options& options) {
  if (options.paused) held.hold();
  const bool isReal = subject.speed.has_value();
  auto opened =
      embed::openPage({.program = subject.program,
                       .executable = subject.executable,
                       .pause = held,
                       .inbox = inbox,
                       .speed = subject.speed,
                       .whyNoControl = options.no_controls ? "pages cannot influence this run" : "",
                       .whyNoPause = isReal ? "only runs in simulated time can be paused: the "
                                              "program that executes this one would go on"
                                            : "",
                       .askToEnd = std::move(subject.askToEnd),
                       .whyNoClose = "the program that has executed the run shows it until it ends",
                       .waits = false},
                      options.port);
  if (!opened) return failed(PROSKILL_SYSTEM_ERROR, std::move(opened.error()));
  page = std::move(*opened);
  url = page->url();
  steps = page->observer();
  return {};
}

std::unique_ptr<runtime::Clock> LiveView::pausable(std::unique_ptr<runtime::Clock> clock) {
  return runtime::pausableClock(std::move(clock), held);
}

runtime::Platform& LiveView::control(runtime::Platform& platform) {
  controlled = runtime::withInbox(platform, inbox, false);
  return *controlled;
}

} // namespace proskill::embed
