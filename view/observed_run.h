#pragma once

#include "runtime/control/pause.h"
#include "runtime/control/signal_inbox.h"

#include <functional>
#include <optional>
#include <string>

namespace proskill::view {

/// A run that pages may see, and what they may do to it. \pre the references outlive its page
struct ObservedRun {
  const analysis::Program& program;
  const runtime::Executable& executable;
  runtime::Pause& pause;
  runtime::SignalInbox& inbox;
  std::optional<double> speed; ///< seconds of the run per second; nullopt: simulated time
  std::string whyNoControl;    ///< empty: pages may influence it
  std::string whyNoPause;      ///< empty: pages may pause it
  std::function<void()> askToEnd;
  std::string whyNoClose{}; ///< empty: when the run has ended, pages may end its page
  bool waits = true;        ///< a run in simulated time waits for slow pages
};

} // namespace proskill::view
