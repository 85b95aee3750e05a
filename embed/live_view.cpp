#include "embed/live_view.h"

#include "embed/page_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace proskill::embed {

namespace {

std::expected<proskill_view_options, Failure> completed(const proskill_view_options* given) {
  constexpr auto kFirstVersion = offsetof(proskill_view_options, hold);
  proskill_view_options options = PROSKILL_VIEW_OPTIONS;
  if (!given) return options;
  if (given->size < kFirstVersion)
    return failed(PROSKILL_INVALID_ARGUMENT, "options must begin as PROSKILL_VIEW_OPTIONS");
  std::memcpy(&options, given, std::min(given->size, sizeof options));
  return options;
}

/// \return "" if pages may pause the run
std::string whyNoPause(const LiveView::Subject& subject, const proskill_view_options& options) {
  if (!subject.speed) return "";
  if (!subject.whoGoesOn.empty()) return subject.whoGoesOn;
  if (options.hold) return "";
  return "only runs in simulated time can be paused, and those whose program has a function "
         "`hold`: this one would go on";
}

Done suits(const LiveView::Subject& subject, const proskill_view_options& options) {
  if (!options.paused) return {};
  if (const auto why = whyNoPause(subject, options); !why.empty())
    return failed(PROSKILL_INVALID_ARGUMENT, "the run cannot begin `paused`: " + why);
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
  if (auto done = suits(subject, *options); !done) return std::unexpected(std::move(done.error()));
  std::unique_ptr<LiveView> made(new LiveView);
  if (auto done = made->openPage(std::move(subject), *options); !done)
    return std::unexpected(std::move(done.error()));
  return made;
}

Done LiveView::openPage(Subject subject, const proskill_view_options& options) {
  if (options.paused) held.hold();
  const auto fixed = whyNoPause(subject, options);
  isPausable = fixed.empty();
  if (isPausable && subject.speed) holder = {options.hold, options.data};
  auto opened =
      embed::openPage({.program = subject.program,
                       .executable = subject.executable,
                       .pause = held,
                       .inbox = inbox,
                       .speed = subject.speed,
                       .whyNoControl = options.no_controls ? "pages cannot influence this run" : "",
                       .whyNoPause = fixed,
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

Done LiveView::tellHold(proskill_executor* executor) {
  if (!holder.function || held.isHeld() == holder.isTold) return {};
  holder.isTold = !holder.isTold;
  try {
    holder.function(executor, holder.isTold, holder.data);
  } catch (const std::exception& error) {
    return failed(PROSKILL_SYSTEM_ERROR, fmt::format("`hold`: {}", error.what()));
  } catch (...) {
    return failed(PROSKILL_SYSTEM_ERROR, "an exception has left the function `hold`");
  }
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
