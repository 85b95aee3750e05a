#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

#include <sys/stat.h>

using namespace proskill;
using test::Finished;
namespace fs = std::filesystem;

namespace {

constexpr const char* kLamp = "(defsv lamp :states (On Off) :init Off :transitions :all)\n";

/// Ends by a signal of its own if it would wait for ever.
Finished soon(std::vector<std::string> words) {
  words.insert(words.begin(), {"/usr/bin/timeout", "20", PROSKILL_PROGRAM});
  return test::run(words);
}

/// The path is not a regular file; users get this reason.
struct Odd {
  std::string path;
  std::string reason;
};

std::vector<Odd> oddPaths(const test::TemporaryDirectory& files) {
  REQUIRE(mkfifo(files.path("pipe").c_str(), 0600) == 0);
  fs::create_directory(files.path("folder"));
  fs::create_symlink("/dev/zero", files.path("endless"));
  fs::create_symlink("round", files.path("round"));
  std::ofstream(files.path("huge")).put(' ');
  fs::resize_file(files.path("huge"), std::uintmax_t{1} << 40);
  return {{files.path("pipe"), "it is a pipe, and only regular files are read"},
          {files.path("folder"), "is a directory"},
          {files.path("endless"), "it is a device, and only regular files are read"},
          {"/dev/tty", "it is a device, and only regular files are read"},
          {files.path("round"), "too many levels of symbolic links"},
          {files.path("huge"), "it is larger than 256 MiB"}};
}

} // namespace

TEST_CASE("a root that is no file, or too large, is refused at once with the reason") {
  const test::TemporaryDirectory files;
  for (const auto& [path, reason] : oddPaths(files))
    for (const auto& words : std::vector<std::vector<std::string>>{{"check"},
                                                                   {"check", "--fix"},
                                                                   {"fmt"},
                                                                   {"emit", "fiacre"},
                                                                   {"verify"},
                                                                   {"graph"},
                                                                   {"view", "--no-open"}}) {
      INFO(words.front() << " " << path);
      auto command = words;
      command.push_back(path);
      const auto done = soon(command);
      CHECK(done.exitCode == 2);
      CHECK(done.err.find(path) != std::string::npos);
      CHECK(done.err.find(reason) != std::string::npos);
      CHECK(done.peakKiB < 1024 * 1024); // this process, from which it was forked, counts as well
    }
}

TEST_CASE("an include that is no file, or too large, is an error at its place") {
  const test::TemporaryDirectory files;
  for (const auto& [path, reason] : oddPaths(files)) {
    INFO(path);
    const auto root = files.write("main.proskill", kLamp + ("(include \"" + path + "\")\n"));
    const auto done = soon({"check", "--format", "short", root});
    CHECK(done.exitCode == 1);
    CHECK(done.out == root + ":2:11: error[PS0006]: cannot read `" + path + "`: " + reason + "\n");
  }
}

TEST_CASE("models, environments, properties and traces that are no files are refused") {
  const test::TemporaryDirectory files;
  const auto root = files.write("main.proskill", kLamp);
  REQUIRE(mkfifo(files.path("pipe.fcr").c_str(), 0600) == 0);
  REQUIRE(mkfifo(files.path("pipe.json").c_str(), 0600) == 0);
  for (const auto& words : std::vector<std::vector<std::string>>{
           {"check", files.path("pipe.fcr")},
           {"fmt", files.path("pipe.fcr")},
           {"verify", files.path("pipe.fcr")},
           {"verify", "--environment", files.path("pipe.fcr"), root},
           {"verify", "--properties", files.path("pipe.fcr"), root},
           {"view", "--no-open", files.path("pipe.json")}}) {
    INFO(words.front() << " " << words[1]);
    const auto done = soon(words);
    CHECK(done.exitCode == 2);
    CHECK(done.err.find("it is a pipe") != std::string::npos);
  }
}

TEST_CASE("settings that are no file are none, and those that are too large a mistake") {
  const test::TemporaryDirectory files;
  const auto root = files.write("main.proskill", kLamp);
  REQUIRE(mkfifo(files.path(".proskill.json").c_str(), 0600) == 0);
  CHECK(soon({"check", root}).exitCode == 0);
  fs::remove(files.path(".proskill.json"));
  files.write(".proskill.json", "{}");
  fs::resize_file(files.path(".proskill.json"), std::uintmax_t{1} << 40);
  const auto done = soon({"check", root});
  CHECK(done.exitCode == 2);
  CHECK(done.err.find("it is larger than 256 MiB") != std::string::npos);
}

TEST_CASE(
    "models of many megabytes are read and laid out in linear time, or refused with a place") {
  const test::TemporaryDirectory files;
  const auto many = [](const std::string& part, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += part;
    return text;
  };
  const std::string chain = "const c : int is 0" + many("+1", 1'000'000) + "\n";
  for (const auto& [text, code] :
       std::vector<std::pair<std::string, int>>{{many("// a comment of a line\n", 4'000'000), 0},
                                                {many("/* a */ ", 1'000'000), 0},
                                                {many("type t is 0..1 // why\n\n\n", 300'000), 1},
                                                {chain, 1}}) {
    const auto path = files.write("large.fcr", text);
    INFO(text.substr(0, 30));
    CHECK(soon({"check", path}).exitCode == code);
    CHECK(soon({"fmt", "--check", path}).exitCode <= 1);
  }
  CHECK(soon({"check", "--format", "short", files.write("chain.fcr", chain)})
            .out.find("too many operators in a row") != std::string::npos);
}

namespace {

/// A model with one step and one property.
std::string modelOf(const std::string& statement, const std::string& property) {
  return "process p is\nstates s0, s1\nvar x : nat := 0, b : bool := false\nfrom s0 " + statement +
         "; to s1\ncomponent main is par p end\n" +
         (property.empty() ? "" : "property q is " + property + "\n") + "main\n";
}

std::string times(std::size_t count, const std::string& part) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += part;
  return text;
}

/// Nested chains of operators: `deep` of them, each with `long` operators.
std::string chains(std::size_t deep, std::size_t length, const std::string& operand,
                   const std::string& sign) {
  return times(deep, "(") + operand + times(deep, times(length, sign + operand) + ")");
}

/// Expressions and formulas whose height grows with each of `count` operators.
std::vector<std::string> towers(std::size_t count) {
  const std::string here = "(main/1/state s0)";
  std::string named = "property q0 is ltl " + here + "\n";
  for (std::size_t i = 1; i < std::min<std::size_t>(count, 600); ++i)
    named += "property q" + std::to_string(i) + " is ltl [] q" + std::to_string(i - 1) + "\n";
  return {modelOf("x := " + chains(1, count, "x", " + "), ""),
          modelOf("x := " + chains(count / 10, 10, "x", " + "), ""),
          modelOf("on " + chains(1, count, "b", " and "), ""),
          modelOf("b := " + times(count / 2, "not ") + "b", ""),
          modelOf("x := " + times(count / 10, "(1 + ") + "x" + times(count / 10, ")"), ""),
          modelOf("x := 0", "absent (main/1/value x" + times(count, " + 1") + " = 3)"),
          modelOf("x := 0", "ltl " + times(count / 2, here + " => ") + here),
          modelOf("x := 0", "ltl " + times(count / 2, here + " until ") + here),
          modelOf("x := 0", "ltl " + times(count / 2, here + " release ") + here),
          modelOf("x := 0", "ltl " + times(count / 2, "[] ") + here),
          modelOf("x := 0", "") + named,
          "const c : int is " + chains(1, count, "1", " + ") + "\n" + modelOf("x := 0", "")};
}

/// With the usual stack sizes of threads and the main thread.
Finished onUsualStack(const std::string& command, const std::string& path) {
  return test::run(
      {"/bin/sh", "-c",
       "ulimit -s 8192; exec timeout 60 " PROSKILL_PROGRAM " " + command + " " + path});
}

} // namespace

TEST_CASE("an expression of any height is read within the stack, or refused with a place") {
  const test::TemporaryDirectory files;
  for (const std::size_t count : {1'900, 2'100, 100'000})
    for (const auto& text : towers(count)) {
      INFO(count << " in " << text.substr(0, 200));
      const auto path = files.write("tower.fcr", text);
      for (const char* command : {"check", "fmt --check", "verify --time-limit 1"})
        CHECK(onUsualStack(command, path).exitCode <= 3);
    }
}

TEST_CASE("long chains within each other are as high as they are together") {
  const test::TemporaryDirectory files;
  for (const std::size_t deep : {4, 40, 200}) {
    const auto path =
        files.write("chains.fcr", modelOf("x := " + chains(deep, 999, "x", " + "), ""));
    const auto done = onUsualStack("check --format short", path);
    CHECK(done.exitCode == 1);
    CHECK(done.out.find("too many operators in a row") != std::string::npos);
  }
}

TEST_CASE("formulas that are named cannot double without end") {
  const test::TemporaryDirectory files;
  std::string text = modelOf("x := 0", "") + "property q0 is ltl (main/1/state s0)\n";
  for (int i = 1; i < 60; ++i) {
    const auto before = "q" + std::to_string(i - 1);
    text += "property q" + std::to_string(i) + " is ltl " + before + " and " + before + "\n";
  }
  const auto done = onUsualStack("check --format short", files.write("double.fcr", text));
  CHECK(done.exitCode == 1);
  CHECK(done.out.find("too large with the named formulas") != std::string::npos);
}
