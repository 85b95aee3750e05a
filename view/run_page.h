#pragma once

#include "runtime/executor/observer.h"
#include "runtime/executor/run_options.h"
#include "view/observed_run.h"

#include <expected>
#include <memory>

namespace proskill::view {

/// A page that shows a run, on the loopback interface, served by threads of its own until it is
/// destroyed.
class RunPage {
public:
  RunPage() = default;
  RunPage(const RunPage&) = delete;
  RunPage& operator=(const RunPage&) = delete;
  virtual ~RunPage() = default;

  /// Its address, with a token that requests must have.
  [[nodiscard]] virtual std::string url() const = 0;
  /// Whether there are events or interrupts that the run may take.
  [[nodiscard]] virtual bool takesSignals() const = 0;
  /// Passes on the run. \pre this outlives it
  [[nodiscard]] virtual std::unique_ptr<runtime::Observer> observer() = 0;
  /// The run has ended: the page shows the whole of it.
  virtual void finish(const runtime::RunResult& result) = 0;
};

/// The page, or why there is none.
using OpenedPage = std::expected<std::unique_ptr<RunPage>, std::string>;

/// Serves a page for a run. \param port 0: any free one
[[nodiscard]] OpenedPage openRunPage(ObservedRun run, std::uint16_t port);

} // namespace proskill::view
