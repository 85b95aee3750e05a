#include "process/run.h"

#include "process/supervisor.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace proskill::process {

namespace {

using Clock = std::chrono::steady_clock;

/// A pipe. Its ends are closed by the destructor, and in programs that are started.
class Pipe {
public:
  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) ends = {-1, -1};
  }
  ~Pipe() {
    closeReading();
    closeWriting();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] bool isOpen() const { return ends[0] >= 0; }
  [[nodiscard]] int reading() const { return ends[0]; }
  [[nodiscard]] int writing() const { return ends[1]; }
  void closeReading() { shut(ends[0]); }
  void closeWriting() { shut(ends[1]); }

private:
  static void shut(int& end) {
    if (end >= 0) ::close(end);
    end = -1;
  }

  std::array<int, 2> ends{-1, -1};
};

/// Blocks the signals that the supervisor waits for.
class BlockedSignals {
public:
  BlockedSignals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGCHLD);
    pthread_sigmask(SIG_BLOCK, &signals, &before);
  }
  ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

private:
  sigset_t before{};
};

/// Reads the available bytes; returns false at the end.
bool take(int from, std::string& into) {
  char buffer[65536];
  const auto count = read(from, buffer, sizeof buffer);
  if (count > 0) into.append(buffer, static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

std::string_view lastLine(std::string_view text) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  const auto start = text.rfind('\n');
  return start == std::string_view::npos ? text : text.substr(start + 1);
}

/// A program and its supervisor, until both have ended.
class Running {
public:
  explicit Running(const Job& of) : job(of) {}
  ~Running() { end(); }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  bool start() {
    if (!out.isOpen() || !err.isOpen() || !report.isOpen()) return false;
    std::vector<char*> arguments;
    for (const auto& word : job.command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const Supervised program{arguments.data(), job.directory.c_str(), job.memory,
                             out.writing(),    err.writing(),         report.writing()};
    const pid_t self = getpid();
    const BlockedSignals
        held; // blocked, so that an early signal reaches the supervisor, not our handlers
    supervisor = fork();
    if (supervisor == 0) supervise(program, self);
    out.closeWriting();
    err.closeWriting();
    report.closeWriting();
    return supervisor > 0;
  }

  std::expected<Finished, std::string> wait() {
    while (!over()) listen();
    end();
    listen(); // read the rest of the output
    finished.seconds = seconds();
    if (told.error != 0) return std::unexpected(std::string(std::strerror(told.error)));
    return std::move(finished);
  }

private:
  static constexpr int kPatience = 100; // in milliseconds

  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(Clock::now() - started).count();
  }

  /// Whether it has ended or must be killed.
  bool over() {
    if (isTold) {
      if (WIFSIGNALED(told.status)) finished.ending = Ending::Signalled;
      finished.code = WIFSIGNALED(told.status) ? WTERMSIG(told.status) : WEXITSTATUS(told.status);
      return true;
    }
    if (job.cancelled && job.cancelled->load()) return ends(Ending::Cancelled);
    if (job.seconds && seconds() > *job.seconds) return ends(Ending::TimedOut);
    if (finished.out.size() + finished.err.size() > job.mostOutput)
      return ends(Ending::TooMuchOutput);
    return false;
  }

  bool ends(Ending how) {
    finished.ending = how;
    return true;
  }

  /// Waits briefly for output.
  void listen() {
    std::array<pollfd, 3> all{pollfd{out.reading(), POLLIN, 0}, pollfd{err.reading(), POLLIN, 0},
                              pollfd{report.reading(), POLLIN, 0}};
    for (bool more = true; more && !isTooMuch();) {
      more = poll(all.data(), all.size(), supervisor > 0 ? kPatience : 0) > 0;
      if (all[0].revents != 0 && !take(out.reading(), finished.out)) all[0].fd = -1;
      if (all[1].revents != 0 && !take(err.reading(), finished.err)) all[1].fd = -1;
      if (all[2].revents != 0) {
        hear();
        all[2].fd = -1;
      }
      if (all[0].fd < 0) out.closeReading();
      if (all[1].fd < 0) err.closeReading();
      if (supervisor > 0) break;
    }
    if (job.progress && supervisor > 0 && seconds() >= nextProgress) {
      nextProgress = seconds() + kPatience / 1000.0;
      const auto& said = finished.out.empty() ? finished.err : finished.out;
      job.progress(seconds(), lastLine(said));
    }
  }

  [[nodiscard]] bool isTooMuch() const {
    return finished.out.size() + finished.err.size() > job.mostOutput;
  }

  /// Reads the supervisor's report. A supervisor without one was itself killed.
  void hear() {
    if (read(report.reading(), &told, sizeof told) != sizeof told) told = {.status = SIGKILL};
    isTold = true;
    report.closeReading();
  }

  void end() {
    if (supervisor <= 0) return;
    kill(supervisor, SIGTERM);
    while (waitpid(supervisor, nullptr, 0) < 0 && errno == EINTR) {
    }
    supervisor = -1;
  }

  const Job& job;
  Pipe out;
  Pipe err;
  Pipe report;
  pid_t supervisor = -1;
  Report told;
  bool isTold = false;
  Finished finished;
  Clock::time_point started = Clock::now();
  double nextProgress = 0;
};

} // namespace

std::string Finished::words() const {
  switch (ending) {
  case Ending::Exited: return fmt::format("ended with exit code {}", code);
  case Ending::Signalled: return fmt::format("was ended by signal {} ({})", code, strsignal(code));
  case Ending::TimedOut: return fmt::format("was ended after {:.0f} s, the time limit", seconds);
  case Ending::Cancelled: return "was cancelled";
  case Ending::TooMuchOutput: return "wrote too much output and was stopped";
  }
  return {};
}

std::expected<Finished, std::string> run(const Job& job) {
  Running running(job);
  if (!running.start()) return std::unexpected(std::string(std::strerror(errno)));
  return running.wait();
}

} // namespace proskill::process
