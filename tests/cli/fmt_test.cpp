#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace proskill::test::fmt_test {

namespace {

constexpr auto kCrooked = "(defevent   e)\n(defsv  a\n:init 1 :max 2)\n";
constexpr auto kStraight = "(defevent e)\n(defsv a\n  :init 1\n  :max 2)\n";

std::string readFile(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

Finished layOut(std::vector<std::string> words, const std::string& input = "") {
  words.insert(words.begin(), {PROSKILL_PROGRAM, "fmt"});
  return run(words, {.input = input});
}

} // namespace

TEST_CASE("fmt lays out files in place, and keeps their permissions") {
  namespace fs = std::filesystem;
  const TemporaryDirectory directory;
  const auto file = directory.write("main.proskill", kCrooked);
  fs::permissions(file, fs::perms::owner_all);
  const auto link = directory.path("link.proskill");
  fs::create_symlink(file, link);
  const Finished result = layOut({link});
  CHECK(result.exitCode == 0);
  CHECK(result.out + result.err == "");
  CHECK(readFile(file) == kStraight);
  CHECK(fs::is_symlink(link));
  CHECK(fs::status(file).permissions() == fs::perms::owner_all);
  CHECK(std::distance(fs::directory_iterator(directory.path()), fs::directory_iterator()) == 2);
}

TEST_CASE("fmt reads standard input where the file is called -") {
  const Finished result = layOut({"-"}, kCrooked);
  CHECK(result.exitCode == 0);
  CHECK(result.out == kStraight);
}

TEST_CASE("fmt --check names what it would change, and changes nothing") {
  const TemporaryDirectory directory;
  const auto crooked = directory.write("crooked.proskill", kCrooked);
  const auto straight = directory.write("straight.proskill", kStraight);
  const Finished result = layOut({"--check", straight, crooked});
  CHECK(result.exitCode == 1);
  CHECK(result.out == crooked + "\n");
  CHECK(readFile(crooked) == kCrooked);
  CHECK(layOut({"--check", straight}).exitCode == 0);
}

TEST_CASE("fmt --diff prints what it would change") {
  const TemporaryDirectory directory;
  const auto file = directory.write("main.proskill", kCrooked);
  const Finished result = layOut({"--diff", file});
  CHECK(result.exitCode == 0);
  CHECK(result.out == "--- " + file + "\n+++ " + file +
                          "\n@@ -1,3 +1,4 @@\n-(defevent   e)\n-(defsv  a\n-:init 1 :max 2)\n"
                          "+(defevent e)\n+(defsv a\n+  :init 1\n+  :max 2)\n");
  CHECK(layOut({"--diff", "--check", file}).exitCode == 1);
  CHECK(readFile(file) == kCrooked);
}

TEST_CASE("fmt --diff is what patch takes") {
  const TemporaryDirectory directory;
  std::string text;
  for (int i = 0; i < 40; ++i)
    text += "(defsv a" + std::to_string(i) + (i % 9 == 4 ? "  :init 1 :max 2)\n" : " :init 1)\n");
  const auto file = directory.write("main.proskill", text.substr(0, text.size() - 1));
  const auto patch = directory.write("patch", layOut({"--diff", file}).out);
  const Finished patched = run({"/usr/bin/patch", "-s", file, patch});
  CHECK(patched.out + patched.err == "");
  CHECK(layOut({"--check", file}).exitCode == 0);
}

TEST_CASE("fmt says what it leaves as it is") {
  const Finished result = layOut({"-"}, "(defevent  e)\n(defsv  a :init (1\n(defevent  f)\n");
  CHECK(result.exitCode == 0);
  CHECK(result.out == "(defevent e)\n(defsv  a :init (1\n(defevent f)\n");
  CHECK(result.err == "standard input:2: not formatted; run `proskill check` to see its errors\n");
}

TEST_CASE("fmt lays out Fiacre, and leaves what it cannot read") {
  const std::string crooked =
      "process P is states a // one\nfrom a loop component m is par P end m";
  const std::string straight =
      "process P is\nstates a // one\n\nfrom a\n    loop\n\ncomponent m is\npar\n    P\nend\n\nm\n";
  const TemporaryDirectory directory;
  const auto file = directory.write("m.fcr", crooked);
  CHECK(layOut({"--check", file}).out == file + "\n");
  CHECK(layOut({"--diff", file}).out.starts_with("--- " + file));
  CHECK(layOut({file}).exitCode == 0);
  CHECK(readFile(file) == straight);
  CHECK(layOut({"--check", file}).exitCode == 0);
  const auto broken = directory.write("broken.fcr", "process   P is");
  const Finished result = layOut({broken});
  CHECK(result.exitCode == 0);
  CHECK(result.err == broken + ": not formatted; run `proskill check` to see its errors\n");
  CHECK(readFile(broken) == "process   P is");
}

TEST_CASE("fmt tells of files that cannot be read") {
  const Finished result = layOut({"no_such_file.proskill"});
  CHECK(result.exitCode == 2);
  CHECK(result.err.starts_with("error: cannot read `no_such_file.proskill`: "));
}

} // namespace proskill::test::fmt_test
