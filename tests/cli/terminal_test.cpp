#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace proskill::test;

namespace {

/// The output of `proskill check` on a terminal.
std::string onTerminal(const std::string& file, const std::vector<std::string>& environment) {
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  REQUIRE(child >= 0);
  if (child == 0) {
    unsetenv("NO_COLOR");
    for (const auto& entry : environment) {
      const auto equals = entry.find('=');
      setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
    }
    execl(PROSKILL_PROGRAM, PROSKILL_PROGRAM, "check", file.c_str(), nullptr);
    _exit(127);
  }
  std::string text;
  char buffer[4096];
  for (ssize_t count; (count = read(terminal, buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<std::size_t>(count));
  close(terminal);
  int status = 0;
  waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 1);
  return text;
}

} // namespace

TEST_CASE("a terminal gets colours, unless NO_COLOR is set") {
  const TemporaryDirectory directory;
  const std::string file = directory.write("main.proskill", "(defskill s)\n");
  CHECK(onTerminal(file, {}).find("\x1b[1;31m") != std::string::npos);
  CHECK(onTerminal(file, {"NO_COLOR="}).find("\x1b[1;31m") != std::string::npos);
  CHECK(onTerminal(file, {"NO_COLOR=1"}).find('\x1b') == std::string::npos);
}
