#include "tests/robustness/broken_text.h"
#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>

#include <unistd.h>

using namespace proskill;
using test::Finished;

namespace {

Finished proskillOn(const std::string& command, const std::string& path) {
  return test::run({PROSKILL_PROGRAM, command, path});
}

/// Ends by itself: without findings, with findings, or with an error message; never with 70, which
/// means a bug.
bool isOrderly(const Finished& finished) {
  return finished.exitCode >= 0 && finished.exitCode <= 3;
}

const std::vector<std::string> kCommands{"check", "emit", "verify", "graph"};

Finished runOn(const std::string& command, const std::string& path) {
  if (command == "emit") return test::run({PROSKILL_PROGRAM, "emit", "fiacre", path});
  return proskillOn(command, path);
}

} // namespace

TEST_CASE("every command answers a broken text with a diagnostic or an error, and ends") {
  test::TemporaryDirectory directory;
  for (const auto& [name, text] : test::brokenTexts()) {
    std::string path = directory.write("broken.proskill", text);
    for (const auto& command : kCommands) {
      INFO(name << ", " << command);
      Finished finished = runOn(command, path);
      CHECK(isOrderly(finished));
      if (finished.exitCode != 0) CHECK_FALSE((finished.out + finished.err).empty());
    }
  }
}

TEST_CASE("every command survives random bytes and random words") {
  test::TemporaryDirectory directory;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    std::string path =
        directory.write("random.proskill", seed % 2 ? test::randomBytes(seed, 20'000)
                                                    : test::randomWords(seed, 5'000));
    for (const auto& command : kCommands) {
      INFO("seed " << seed << ", " << command);
      CHECK(isOrderly(runOn(command, path)));
    }
  }
}

TEST_CASE("a hundred megabytes in one line take memory in proportion") {
  test::TemporaryDirectory directory;
  constexpr std::size_t kMegabyte = 1'000'000;
  for (const auto& [name, part] : std::vector<std::pair<std::string, std::string>>{
           {"a comment", ";xxxxxxx"}, {"one name", "abcdefgh"}}) {
    INFO(name);
    Finished small =
        proskillOn("check", directory.write("small.proskill", test::repeated(part, kMegabyte / 8)));
    Finished large = proskillOn(
        "check", directory.write("large.proskill", test::repeated(part, 100 * kMegabyte / 8)));
    CHECK(isOrderly(small));
    CHECK(isOrderly(large));
    CHECK(large.peakKiB < 12 * 100 * 1024); // a dozen bytes for each byte of the text
  }
}

TEST_CASE("memory grows as the program does") {
  test::TemporaryDirectory directory;
  auto program = [](std::size_t events) {
    std::string text = "(defsv v :states (A B) :init A)\n";
    for (std::size_t i = 0; i < events; ++i)
      text += "(defevent e" + std::to_string(i) + " :effects (v A))\n";
    return text;
  };
  Finished few = proskillOn("check", directory.write("few.proskill", program(5'000)));
  Finished many = proskillOn("check", directory.write("many.proskill", program(50'000)));
  CHECK(isOrderly(few));
  CHECK(isOrderly(many));
  CHECK(many.peakKiB < 15 * few.peakKiB);
}

TEST_CASE("very large programs of one kind each are checked, with memory in proportion") {
  test::TemporaryDirectory directory;
  auto program = [](const std::string& kind, std::size_t count) {
    std::string text;
    std::string body;
    for (std::size_t i = 0; i < count; ++i) {
      std::string n = std::to_string(i);
      text += "(defskill s" + n + " :success ok :failure no ";
      text += kind == "a chain" && i > 0
                  ? ":body ((s" + std::to_string(i - 1) + ") (success ok)))\n"
                  : ":action (act))\n";
      if (kind == "a sequence")
        body += "(s" + n + ") (if (= s" + n + ".status success) (success))\n";
      if (kind == "branches") body += "((s" + n + "))";
    }
    if (kind == "branches") body = "(// " + body + ")";
    return body.empty() ? text : text + "(defskill mission :body (" + body + "))\n";
  };
  for (const char* kind : {"a library", "a chain", "a sequence", "branches"}) {
    INFO(kind);
    Finished few = proskillOn("check", directory.write("few.proskill", program(kind, 1'000)));
    Finished many = proskillOn("check", directory.write("many.proskill", program(kind, 10'000)));
    CHECK(isOrderly(few));
    CHECK(isOrderly(many));
    CHECK(many.peakKiB < 20 * few.peakKiB);
  }
}

TEST_CASE("a file that is not there, a directory, and a file that may not be read are told apart "
          "from findings") {
  test::TemporaryDirectory directory;
  std::vector<std::string> paths{directory.path("absent.proskill"), directory.path()};
  std::string secret = directory.write("secret.proskill", "(defevent e)");
  std::filesystem::permissions(secret, std::filesystem::perms::none);
  if (access(secret.c_str(), R_OK) != 0) paths.push_back(secret); // root may read everything
  for (const auto& path : paths)
    for (const auto& command : kCommands) {
      INFO(path << ", " << command);
      Finished finished = runOn(command, path);
      CHECK(finished.exitCode >= 1);
      CHECK(finished.exitCode <= 2);
      if (command == "check") CHECK(finished.exitCode == 2);
      CHECK(finished.err.find(std::filesystem::path(path).filename().string()) !=
            std::string::npos);
    }
}

TEST_CASE(
    "an include that is absent, a directory, or binary is a finding of the file that includes it") {
  test::TemporaryDirectory directory;
  directory.write("binary.proskill", test::randomBytes(1, 5'000));
  for (const char* included : {"absent.proskill", ".", "binary.proskill", "main.proskill", ""}) {
    INFO("include " << included);
    std::string path =
        directory.write("main.proskill", "(include \"" + std::string(included) + "\")\n");
    Finished finished = proskillOn("check", path);
    CHECK(isOrderly(finished));
    CHECK(finished.exitCode == 1);
  }
}

TEST_CASE("a chain of includes is followed, and one without an end in sight is refused") {
  test::TemporaryDirectory directory;
  for (int i = 0; i < 1000; ++i)
    directory.write("f" + std::to_string(i) + ".proskill",
                    "(include \"f" + std::to_string(i + 1) + ".proskill\")\n");
  directory.write("f1000.proskill",
                  "(defsv v :states (A B) :init A)\n(defsv v :states (A B) :init A)\n");
  Finished near = proskillOn("check", directory.path("f900.proskill"));
  CHECK(near.exitCode == 1);
  CHECK((near.out + near.err).find("f1000.proskill") != std::string::npos);
  Finished far = proskillOn("check", directory.path("f0.proskill"));
  CHECK(far.exitCode == 1);
  CHECK((far.out + far.err).find("too deep") != std::string::npos);
}
