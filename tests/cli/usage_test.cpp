#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

namespace proskill::test::usage_test {

using proskill::test::run;

namespace {

const std::string kDock = PROSKILL_SOURCE_DIR "/docs/tour/dock.proskill";

/// The first line of the error that a wrong command line gives.
std::string wrong(std::vector<std::string> words) {
  words.insert(words.begin(), PROSKILL_PROGRAM);
  const auto done = run(words);
  CHECK(done.exitCode == 2);
  CHECK(done.out.empty());
  CHECK(done.err.find("--help` for more\n") != std::string::npos);
  return done.err.substr(0, done.err.find('\n'));
}

} // namespace

TEST_CASE("an unknown option is named, with the one that was probably meant") {
  CHECK(wrong({"verify", "--formt", "json", kDock}) ==
        "error: there is no option `--formt`; did you mean `--format`?");
  CHECK(wrong({"verify", "--formt=json", kDock}) ==
        "error: there is no option `--formt`; did you mean `--format`?");
  CHECK(wrong({"check", "--hlep"}) == "error: there is no option `--hlep`; did you mean `--help`?");
  CHECK(wrong({"check", "-x", kDock}) == "error: there is no option `-x`");
  CHECK(wrong({"--foo"}) == "error: there is no option `--foo`");
  CHECK(wrong({"check", kDock, "--no\033[2J"}) == "error: there is no option `--no\ufffd[2J`");
}

TEST_CASE("a missing or unknown command is said") {
  CHECK(wrong({}) == "error: a command is missing");
  CHECK(wrong({"verfy", kDock}) == "error: there is no command `verfy`; did you mean `verify`?");
}

TEST_CASE("a part of a run may begin at 0, but no run ends there") {
  const auto missing = run({PROSKILL_PROGRAM, "view", "--no-open", "--from", "0", "missing.json"});
  CHECK(missing.err.find("missing.json") != std::string::npos);
  CHECK(missing.err.find("is not a time") == std::string::npos);
  CHECK(wrong({"view", "--from", "-1", "missing.json"}).find("`-1` is not a time") !=
        std::string::npos);
  CHECK(wrong({"run", "--until", "0", kDock}).find("`0` is not a time") != std::string::npos);
  CHECK(wrong({"run", "--clock", "0x", kDock}).find("`0x` is none of") != std::string::npos);
}

TEST_CASE("missing and superfluous arguments are named") {
  CHECK(wrong({"run"}) == "error: `file` is missing: Root file of the program");
  CHECK(wrong({"import"}) == "error: `language` is missing: bt|gen|rl");
  CHECK(wrong({"run", "--clock"}) == "error: `--clock` needs a value: real|simulated|Nx");
  CHECK(wrong({"run", "--main", "a", "--main", "b", kDock}) ==
        "error: `--main` may be given only once");
  CHECK(wrong({"run", "--view=maybe", kDock}) == "error: `--view` takes no value");
  CHECK(wrong({"run", kDock, "b", "c"}) == "error: unexpected argument `b`");
}

TEST_CASE("options that need or exclude each other are named") {
  CHECK(wrong({"run", "--no-open", kDock}) == "error: `--no-open` needs `--view`");
  CHECK(wrong({"run", "--record", "x", "--no-record", kDock}) ==
        "error: `--record` and `--no-record` exclude each other");
}

TEST_CASE("a word that an option does not take is answered with those that it takes") {
  CHECK(wrong({"verify", "--format", "jsn", kDock}) ==
        "error: --format: `jsn` is not one of text, json, junit, sarif; did you mean `json`?");
  CHECK(wrong({"verify", "--reduce", "stuborn-sets", kDock})
            .ends_with("; did you mean `stubborn-sets`?"));
}

TEST_CASE("a number is an integer within the bounds that the error names") {
  for (const auto* word : {"x", "-5", "0", "1.5", "0x10", ""})
    CHECK(wrong({"verify", "--class-limit", word, kDock}) ==
          "error: --class-limit: `" + std::string(word) + "` is not a positive integer");
  CHECK(wrong({"verify", "--memory-limit", "99999999999999999999", kDock}) ==
        "error: --memory-limit: `99999999999999999999` is too large");
  CHECK(wrong({"verify", "--jobs", "257", kDock}) ==
        "error: --jobs: `257` is not an integer from 1 to 256");
  for (const auto* command : {"lsp", "dap"})
    CHECK(wrong({command, "--port", "65536"}) ==
          "error: --port: `65536` is not an integer from 0 to 65535");
}

TEST_CASE("a memory limit beyond what bytes can be counted is no limit") {
  const auto done = run({PROSKILL_PROGRAM, "verify", "--memory-limit", "17592186044416", kDock});
  CHECK(done.out.find("memory limit") == std::string::npos);
  CHECK(done.exitCode == 1); // as without a limit: a property is violated
}

} // namespace proskill::test::usage_test
