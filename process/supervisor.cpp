#include "process/supervisor.h"

#include "process/resource_limit.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace proskill::process {

namespace {

void say(int to, const Report& report) {
  while (write(to, &report, sizeof report) < 0 && errno == EINTR) {
  }
}

void forgetSignals() {
  for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void become(const Supervised& program, pid_t supervisor) {
  setpgid(0, 0);
  forgetSignals();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != supervisor) _exit(1);
  limitResource(RLIMIT_CORE, 0);
  if (program.memory) limitResource(RLIMIT_AS, *program.memory);
  const int nothing = open("/dev/null", O_RDONLY);
  const bool ready = nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 &&
                     dup2(program.out, STDOUT_FILENO) >= 0 &&
                     dup2(program.err, STDERR_FILENO) >= 0 && chdir(program.directory) == 0;
  if (ready) execv(program.arguments[0], program.arguments);
  say(program.report, {.error = errno});
  _exit(127);
}

/// The first child of this process, as the kernel lists them; -1 if there is none.
pid_t firstChild() {
  const int list = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
  if (list < 0) return -1;
  char text[32] = {};
  const auto count = read(list, text, sizeof text - 1);
  close(list);
  return count > 0 ? static_cast<pid_t>(std::strtol(text, nullptr, 10)) : -1;
}

/// Kills processes until none is left. A process whose parent is killed becomes a child of this
/// one.
void sweep(pid_t group) {
  if (group > 0) kill(-group, SIGKILL); // all at once, so that few can react to the end of others
  while (true) {
    const pid_t child = firstChild();
    if (child <= 0) return;
    kill(child, SIGKILL);
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

} // namespace

void supervise(const Supervised& program, pid_t parent) {
  setpgid(0, 0); // a Ctrl-C on the terminal is for the parent only
  sigset_t awaited;
  sigemptyset(&awaited);
  sigaddset(&awaited, SIGTERM);
  sigaddset(&awaited, SIGCHLD);
  ::signal(SIGCHLD, SIG_DFL);
  sigprocmask(SIG_BLOCK, &awaited, nullptr);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);
  const pid_t self = getpid();
  const pid_t child = fork();
  if (child == 0) become(program, self);
  if (child < 0) say(program.report, {.error = errno});
  close(program.out);
  close(program.err);
  for (bool over = child < 0; !over;) {
    siginfo_t got;
    if (sigwaitinfo(&awaited, &got) == SIGTERM) break;
    int status = 0;
    for (pid_t ended = waitpid(-1, &status, WNOHANG); ended > 0;
         ended = waitpid(-1, &status, WNOHANG))
      if (ended == child) {
        say(program.report, {.status = status});
        over = true;
      }
  }
  sweep(child);
  _exit(0);
}

} // namespace proskill::process
