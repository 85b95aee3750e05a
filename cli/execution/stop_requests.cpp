#include "cli/execution/stop_requests.h"

#include <csignal>
#include <cstdint>
#include <poll.h>
#include <sys/eventfd.h>
#include <tuple>
#include <unistd.h>

namespace proskill::cli {

namespace {

std::atomic<int> requests = 0;
int descriptor = -1;
/// Whether a page of the run is closed, too.
std::atomic<bool> mustLeave = false;
/// Whether nobody reads the output any more. This is one request, however much is written.
std::atomic<bool> isUnread = false;

} // namespace

void askToStop(int signal) {
  if (signal == SIGPIPE && isUnread.exchange(true)) return;
  if (signal == SIGTERM || signal == SIGHUP) mustLeave = true;
  ++requests;
  const std::uint64_t one = 1;
  std::ignore = ::write(descriptor, &one, sizeof one);
}

void listenForStops() {
  descriptor = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  struct sigaction action {};
  action.sa_handler = askToStop;
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) sigaction(signal, &action, nullptr);
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr); // by `nohup`
}

const std::atomic<int>& stopRequests() { return requests; }

int stopDescriptor() { return descriptor; }

void awaitStop(int taken) {
  pollfd watched{descriptor, POLLIN, 0};
  while (requests <= taken && !mustLeave) {
    ::poll(&watched, 1, -1);
    std::uint64_t times = 0;
    std::ignore = ::read(descriptor, &times, sizeof times);
  }
}

} // namespace proskill::cli
