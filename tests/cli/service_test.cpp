#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace proskill::test::service_test {

namespace {

/// The socket of a service manager.
class Manager {
public:
  explicit Manager(const std::string& path) {
    sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
    REQUIRE(path.size() < sizeof address.sun_path);
    path.copy(address.sun_path, path.size());
    REQUIRE(::bind(descriptor, static_cast<const sockaddr*>(static_cast<const void*>(&address)),
                   sizeof address) == 0);
  }
  Manager(const Manager&) = delete;
  Manager& operator=(const Manager&) = delete;
  ~Manager() { ::close(descriptor); }

  std::vector<std::string> heard() {
    std::vector<std::string> all;
    std::string message(256, '\0');
    for (;;) {
      const auto size = ::recv(descriptor, message.data(), message.size(), MSG_DONTWAIT);
      if (size < 0) return all;
      all.push_back(message.substr(0, static_cast<std::size_t>(size)));
    }
  }

private:
  int descriptor = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

constexpr std::string_view kWaits = "(defskill mission :success done :body ((^ 1) (success done)))";

} // namespace

TEST_CASE("a run notifies the service manager, and its watchdog") {
  const TemporaryDirectory files;
  const auto file = files.write("mission.proskill", std::string(kWaits));
  Manager manager(files.path("notify"));
  RunOptions options;
  options.environment = {"NOTIFY_SOCKET=" + files.path("notify"), "WATCHDOG_USEC=500000"};
  const auto done = run({PROSKILL_PROGRAM, "run", "--clock", "real", file}, options);
  INFO(done.out << done.err);
  CHECK(done.exitCode == 0);
  const auto heard = manager.heard();
  REQUIRE(heard.size() >= 4);
  CHECK(heard.front() == "READY=1");
  CHECK(heard.back() == "STOPPING=1");
  for (std::size_t i = 1; i + 1 < heard.size(); ++i) CHECK(heard[i] == "WATCHDOG=1");
}

TEST_CASE("a watchdog of another process is not notified, and no socket is no error") {
  const TemporaryDirectory files;
  const auto file = files.write("mission.proskill", std::string(kWaits));
  Manager manager(files.path("notify"));
  RunOptions options;
  options.environment = {"NOTIFY_SOCKET=" + files.path("notify"), "WATCHDOG_USEC=100000",
                         "WATCHDOG_PID=1"};
  CHECK(run({PROSKILL_PROGRAM, "run", "--clock", "real", file}, options).exitCode == 0);
  CHECK(manager.heard() == std::vector<std::string>{"READY=1", "STOPPING=1"});
  options.environment = {"NOTIFY_SOCKET=/nowhere/notify", "WATCHDOG_USEC=100000"};
  CHECK(run({PROSKILL_PROGRAM, "run", "--clock", "real", file}, options).exitCode == 0);
}

TEST_CASE("`--realtime` reports what is refused, and the run goes on") {
  const TemporaryDirectory files;
  const auto file = files.write("mission.proskill", std::string(kWaits));
  const std::vector<std::string> command{PROSKILL_PROGRAM, "run",  "--realtime",
                                         "--clock",        "real", file};
  const auto done = run(command);
  INFO(done.out << done.err);
  CHECK(done.exitCode == 0);
  std::vector<std::string> limited{"prlimit", "--memlock=0", "--rtprio=0"};
  if (geteuid() == 0) limited.insert(limited.begin(), {"setpriv", "--bounding-set=-all"});
  limited.insert(limited.begin(), "/usr/bin/env");
  limited.insert(limited.end(), command.begin(), command.end());
  const auto refused = run(limited);
  INFO(refused.out << refused.err);
  CHECK(refused.exitCode == 0);
  CHECK(refused.err.find("warning: `--realtime`: its memory cannot be locked: ") == 0);
  CHECK(refused.err.find("SCHED_FIFO was refused: ") != std::string::npos);
  const auto simulated = run({PROSKILL_PROGRAM, "run", "--realtime", file});
  CHECK(simulated.exitCode == 2);
  CHECK(simulated.err.find("`--realtime` is for real clocks") != std::string::npos);
}

} // namespace proskill::test::service_test
