#pragma once

#include <atomic>

namespace proskill::cli {

/// Asks runs of this process to end in order at SIGINT, SIGTERM, SIGHUP, and when nobody reads the
/// output any more.
void listenForStops();
/// The same for a request that comes otherwise. \param signal the one that it is like
void askToStop(int signal);

/// The number of requests so far.
[[nodiscard]] const std::atomic<int>& stopRequests();
/// Is readable after a request.
[[nodiscard]] int stopDescriptor();
/// Waits for the next request after those that the run has taken.
void awaitStop(int taken);

} // namespace proskill::cli
