#include "tests/support/run.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace proskill::test {

namespace {

struct Pipe {
  int read = -1;
  int write = -1;
};

Pipe makePipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::strerror(errno));
  return {ends[0], ends[1]};
}

void closeEnd(int& end) {
  if (end >= 0) close(end);
  end = -1;
}

[[noreturn]] void become(const std::vector<std::string>& command, const RunOptions& options,
                         const Pipe& in, const Pipe& out, const Pipe& err) {
  std::signal(SIGPIPE, SIG_DFL);
  dup2(in.read, STDIN_FILENO);
  dup2(out.write, STDOUT_FILENO);
  dup2(err.write, STDERR_FILENO);
  for (const auto& entry : options.environment) {
    auto equals = entry.find('=');
    setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
  }
  std::vector<char*> arguments;
  for (const auto& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  _exit(127);
}

/// Reads the available bytes; returns false at the end.
bool drain(int end, std::string& into) {
  char buffer[65536];
  auto count = read(end, buffer, sizeof buffer);
  if (count > 0) into.append(buffer, static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

void feed(Pipe& in, std::string_view& input) {
  auto count = write(in.write, input.data(), std::min<std::size_t>(input.size(), 65536));
  if (count > 0) input.remove_prefix(static_cast<std::size_t>(count));
  if (count < 0 && errno != EINTR && errno != EAGAIN) input = {};
  if (input.empty()) closeEnd(in.write);
}

/// Passes bytes in both directions until both output streams have ended.
void converse(int child, const RunOptions& options, Pipe& in, Pipe& out, Pipe& err,
              Finished& result) {
  std::string_view input = options.input;
  auto pending = options.onOutput;
  if (input.empty()) closeEnd(in.write);
  while (out.read >= 0 || err.read >= 0) {
    pollfd ends[] = {{out.read, POLLIN, 0}, {err.read, POLLIN, 0}, {in.write, POLLOUT, 0}};
    if (poll(ends, 3, -1) < 0 && errno != EINTR) break;
    if (ends[0].revents != 0 && !drain(out.read, result.out)) closeEnd(out.read);
    if (ends[1].revents != 0 && !drain(err.read, result.err)) closeEnd(err.read);
    if (ends[2].revents != 0) feed(in, input);
    if (pending && !(result.out.empty() && result.err.empty()))
      std::exchange(pending, nullptr)(child);
  }
}

} // namespace

Finished run(const std::vector<std::string>& command, const RunOptions& options) {
  std::signal(SIGPIPE, SIG_IGN);
  auto in = makePipe();
  auto out = makePipe();
  auto err = makePipe();
  auto child = fork();
  if (child < 0) throw std::runtime_error(std::strerror(errno));
  if (child == 0) become(command, options, in, out, err);
  closeEnd(in.read);
  closeEnd(out.write);
  closeEnd(err.write);
  Finished result;
  converse(child, options, in, out, err, result);
  closeEnd(in.write);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  result.exitCode = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  result.peakKiB = usage.ru_maxrss;
  if (result.exitCode == 127) throw std::runtime_error("cannot start " + command.front());
  return result;
}

TemporaryDirectory::TemporaryDirectory() {
  auto pattern = (std::filesystem::temp_directory_path() / "proskill-test-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error(std::strerror(errno));
  root = pattern;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(root, ignored);
}

std::string TemporaryDirectory::path(const std::string& name) const {
  return name.empty() ? root : root + "/" + name;
}

std::string TemporaryDirectory::write(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
  std::ofstream(path(name), std::ios::binary) << text;
  return path(name);
}

} // namespace proskill::test
