#pragma once

#include "tests/lsp/support/session.h"

#include <future>

namespace proskill::test {

/// A client that receives what a part of the server sends.
struct Client {
  Pipe pipe;
  rpc::Outbox outbox{pipe};
  rpc::Peer peer{outbox};
};

/// Waits until the background tasks so far have run.
/// \pre the scheduler has a single thread for them
inline void settle(rpc::Scheduler& scheduler) {
  std::promise<void> settled;
  scheduler.post(rpc::Priority::Background, [&] { settled.set_value(); });
  settled.get_future().wait();
}

} // namespace proskill::test
