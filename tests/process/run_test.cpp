#include "process/run.h"
#include "tests/support/run.h"

#include <catch2/catch.hpp>

#include <cerrno>
#include <csignal>
#include <fstream>

#include <sys/wait.h>
#include <unistd.h>

using namespace proskill;
using process::Ending;

namespace {

process::Job shell(const std::string& text) {
  return {.command = {"/bin/sh", "-c", text}, .directory = "/"};
}

process::Finished finished(const process::Job& job) {
  auto result = process::run(job);
  if (!result) FAIL(result.error());
  return std::move(*result);
}

/// Whether a process exists and is not a zombie.
bool lives(pid_t pid) {
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  std::string word;
  for (int i = 0; i < 3; ++i) stat >> word;
  return stat && word != "Z";
}

pid_t number(const std::string& path) {
  pid_t pid = 0;
  std::ifstream(path) >> pid;
  return pid;
}

} // namespace

TEST_CASE("a program's output, errors and exit code come back") {
  const auto done = finished(shell("echo out; echo err >&2; exit 3"));
  CHECK(done.out == "out\n");
  CHECK(done.err == "err\n");
  CHECK(done.words() == "ended with exit code 3");
  CHECK_FALSE(done.succeeded());
}

TEST_CASE("a program runs in its directory, reads nothing, and gets its words as they are") {
  auto job = shell("pwd; cat; echo \"$0\"");
  job.directory = "/tmp";
  job.command.emplace_back("a b; $HOME '*'");
  CHECK(finished(job).out == "/tmp\na b; $HOME '*'\n");
}

TEST_CASE("a program that cannot be started is an error with the system's reason") {
  const auto none = process::run({.command = {"/no/such/program"}, .directory = "/"});
  REQUIRE_FALSE(none.has_value());
  CHECK(none.error() == "No such file or directory");
  const auto nowhere = process::run({.command = {"/bin/true"}, .directory = "/no/such/place"});
  REQUIRE_FALSE(nowhere.has_value());
}

TEST_CASE("a program that a signal ends says which") {
  CHECK(finished(shell("kill -9 $$")).words() == "was ended by signal 9 (Killed)");
}

TEST_CASE("a program that hangs is ended at its time, with all that it started, wherever it went") {
  const test::TemporaryDirectory files;
  // One child in the group, one in a session of its own whose parent has ended.
  auto job = shell("sleep 600 & echo $! > near; (setsid sh -c 'echo $$ > far; exec sleep 600' &); "
                   "while [ ! -s far ]; do :; done; echo ready; sleep 600");
  job.directory = files.path();
  std::atomic<bool> cancelled{false};
  job.cancelled = &cancelled;
  job.progress = [&](double, std::string_view line) { cancelled = line == "ready"; };
  const auto done = finished(job);
  CHECK(done.ending == Ending::Cancelled);
  CHECK(done.out == "ready\n");
  REQUIRE(number(files.path("near")) > 0);
  REQUIRE(number(files.path("far")) > 0);
  CHECK_FALSE(lives(number(files.path("near"))));
  CHECK_FALSE(lives(number(files.path("far"))));
  job.cancelled = nullptr;
  job.seconds = 0;
  CHECK(finished(job).ending == Ending::TimedOut);
}

TEST_CASE("what a program leaves behind when it ends goes with it") {
  const test::TemporaryDirectory files;
  auto job = shell("sleep 600 & echo $! > left");
  job.directory = files.path();
  CHECK(finished(job).succeeded());
  CHECK_FALSE(lives(number(files.path("left"))));
}

TEST_CASE("a program that says too much is ended; what it said is kept up to there") {
  auto job = shell("while :; do echo line; done");
  job.mostOutput = 100'000;
  const auto done = finished(job);
  CHECK(done.ending == Ending::TooMuchOutput);
  CHECK(done.out.starts_with("line\nline\n"));
  CHECK(done.out.size() < 1'000'000);
}

TEST_CASE("much output on both streams comes whole") {
  const auto done = finished(shell("i=0; while [ $i -lt 3000 ]; do echo 0123456789012345678901234; "
                                   "echo 0123456789012345678901234 >&2; i=$((i+1)); done"));
  CHECK(done.out.size() == 78'000);
  CHECK(done.err.size() == 78'000);
}

TEST_CASE("a memory limit holds for the program, not for us") {
  auto job = shell("x=$(head -c 400000000 /dev/zero | tr '\\0' x); echo ${#x}");
  job.memory = 64 << 20;
  CHECK(finished(job).out != "400000000\n");
}

TEST_CASE("when we are killed ourselves, the program goes, too") {
  const test::TemporaryDirectory files;
  const pid_t us = fork();
  if (us == 0) {
    auto job = shell("sleep 600 & echo $! > child; mv child ready; sleep 600");
    job.directory = files.path();
    const auto done = process::run(job);
    _exit(done ? 0 : 1);
  }
  REQUIRE(us > 0);
  while (number(files.path("ready")) == 0) sched_yield();
  const pid_t child = number(files.path("ready"));
  CHECK(lives(child));
  kill(us, SIGKILL);
  waitpid(us, nullptr, 0);
  while (lives(child)) sched_yield(); // otherwise ctest's time limit ends it
  CHECK_FALSE(lives(child));
}
