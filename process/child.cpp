#include "process/child.h"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace proskill::process {

namespace {

/// Environment of the child: the socket as standard input and output, no other open files, and
/// default signal actions.
class ChildEnvironment {
public:
  explicit ChildEnvironment(int socket) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, socket, STDOUT_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes);
    sigset_t all;
    sigfillset(&all);
    sigdelset(&all, SIGKILL);
    sigdelset(&all, SIGSTOP);
    posix_spawnattr_setsigdefault(&attributes, &all);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  void leadGroupIn(const std::filesystem::path& directory) {
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK |
                                              POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  }
  ~ChildEnvironment() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  ChildEnvironment(const ChildEnvironment&) = delete;
  ChildEnvironment& operator=(const ChildEnvironment&) = delete;

  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
};

std::string words(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("it was ended by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  return fmt::format("it ended with exit code {}", WEXITSTATUS(status));
}

} // namespace

namespace {

struct Started {
  pid_t pid = -1;
  int socket = -1;
};

/// \param directory working directory of the child, which then leads a process group of its own;
/// null: this directory and group
std::expected<Started, std::string> spawned(const std::vector<std::string>& command,
                                            const std::filesystem::path* directory) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return std::unexpected(std::string(std::strerror(errno)));
  std::vector<char*> arguments;
  for (const auto& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = -1;
  ChildEnvironment surroundings(ends[1]);
  if (directory) surroundings.leadGroupIn(*directory);
  const auto spawn = directory ? posix_spawnp : posix_spawn;
  const int error = spawn(&child, arguments[0], &surroundings.actions, &surroundings.attributes,
                          arguments.data(), environ);
  ::close(ends[1]);
  if (error == 0) return Started{child, ends[0]};
  ::close(ends[0]);
  return std::unexpected(std::string(std::strerror(error)));
}

} // namespace

std::expected<Child, std::string> Child::start(const std::vector<std::string>& command) {
  const auto started = spawned(command, nullptr);
  if (!started) return std::unexpected(started.error());
  return Child(started->pid, started->socket, -1, false);
}

std::expected<Child, std::string> Child::startGroup(const std::vector<std::string>& command,
                                                    const std::filesystem::path& directory) {
  const auto started = spawned(command, &directory);
  if (!started) return std::unexpected(started.error());
  // The header of glibc 2.36 does not declare pidfd_open as a C function.
  const auto end = static_cast<int>(syscall(SYS_pidfd_open, started->pid, 0));
  return Child(started->pid, started->socket, end, true);
}

Child::Child(Child&& other) noexcept
    : pid(std::exchange(other.pid, -1)),
      socket(std::exchange(other.socket, -1)),
      ended(std::exchange(other.ended, -1)),
      isGroup(other.isGroup) {}

Child::~Child() {
  if (socket >= 0) ::close(socket);
  if (ended >= 0) ::close(ended);
  if (pid < 0) return;
  signal(SIGKILL);
  while (waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
  }
}

Child::Exchange Child::exchange(std::string_view toSend, std::chrono::milliseconds patience) {
  Exchange done;
  const short wanted = toSend.empty() ? POLLIN : POLLIN | POLLOUT;
  pollfd end{socket, wanted, 0};
  if (poll(&end, 1, static_cast<int>(patience.count())) <= 0) return done;
  if ((end.revents & POLLOUT) != 0 && !toSend.empty()) {
    auto count = ::send(socket, toSend.data(), toSend.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count > 0) done.sent = static_cast<std::size_t>(count);
  }
  if ((end.revents & (POLLIN | POLLHUP | POLLERR)) != 0) {
    char buffer[65536];
    auto count = recv(socket, buffer, sizeof buffer, MSG_DONTWAIT);
    if (count > 0) done.received.assign(buffer, static_cast<std::size_t>(count));
    const bool later = count < 0 && (errno == EAGAIN || errno == EINTR);
    done.ended = count <= 0 && !later;
  }
  return done;
}

std::string Child::ending() {
  int status = 0;
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    if (waitpid(pid, &status, WNOHANG) == pid) {
      pid = -1;
      return words(status);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(pid, SIGKILL);
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  pid = -1;
  return "it did not end and was killed";
}

std::optional<std::string> Child::endingIfOver() {
  siginfo_t over{};
  waitid(P_PID, static_cast<id_t>(pid), &over, WEXITED | WNOHANG | WNOWAIT);
  if (over.si_pid != pid) return std::nullopt;
  signalGroup(SIGKILL); // kill its remaining processes, while its process group cannot be
                        // reused
  int status = 0;
  waitpid(pid, &status, 0);
  pid = -1;
  return words(status);
}

void Child::endInput() { shutdown(socket, SHUT_WR); }

void Child::signal(int number) const {
  kill(pid, number);
  signalGroup(number);
}

void Child::signalGroup(int number) const {
  if (isGroup) kill(-pid, number);
}

bool dieWithParent(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  return getppid() == parent; // otherwise the parent ended before the request
}

} // namespace proskill::process
