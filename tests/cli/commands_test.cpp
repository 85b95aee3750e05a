#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

using namespace proskill::test;

namespace {

Finished runProskill(std::vector<std::string> words) {
  words.insert(words.begin(), PROSKILL_PROGRAM);
  return run(words);
}

std::string readFile(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

} // namespace

TEST_CASE("a mistake in the command is told on standard error and exits with 2") {
  for (const std::vector<std::string>& words : {std::vector<std::string>{},
                                                {"chekc"},
                                                {"check"},
                                                {"check", "--format", "xml", "x"},
                                                {"check", "--no-such-option", "x"},
                                                {"explain"},
                                                {"explain", "PS9999"}}) {
    const Finished result = runProskill(words);
    INFO(result.err);
    CHECK(result.exitCode == 2);
    CHECK(result.out.empty());
    CHECK(result.err.starts_with("error: "));
  }
}

TEST_CASE("a misspelt command comes with the one that was meant") {
  CHECK(runProskill({"chekc", "x"}).err.find("did you mean `check`?") != std::string::npos);
  CHECK(runProskill({"check", "--format", "xml", "x"}).err.find("text, short, json, sarif") !=
        std::string::npos);
}

TEST_CASE("help and version are asked for, so they exit with 0") {
  CHECK(runProskill({"--help"}).out.find("check") != std::string::npos);
  CHECK(runProskill({"--help"}).exitCode == 0);
  CHECK(runProskill({"check", "--help"}).out.find("--format") != std::string::npos);
  CHECK(runProskill({"--version"}).out.starts_with("proskill "));
  CHECK(runProskill({"--version"}).exitCode == 0);
}

TEST_CASE("explain tells a code's paragraph and example") {
  const Finished result = runProskill({"explain", "ps0201"});
  CHECK(result.exitCode == 0);
  CHECK(result.out.starts_with("error[PS0201]: unknown skill `…`\n\nA statement that begins"));
  CHECK(result.out.ends_with("      :body ((camera_survay)))\n"));
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 82);
}

TEST_CASE("explain knows every code that it lists") {
  std::istringstream lines(runProskill({"explain", "--list"}).out);
  std::string previous;
  for (std::string line; std::getline(lines, line);) {
    const std::string code = line.substr(0, 6);
    INFO(code);
    CHECK(previous < code);
    CHECK(runProskill({"explain", code}).exitCode == 0);
    previous = code;
  }
  CHECK(previous > "PS0400");
}

TEST_CASE("an unknown code comes with one that is near") {
  CHECK(runProskill({"explain", "PS021"}).err.find("did you mean PS0") != std::string::npos);
}

TEST_CASE("the manual's page of diagnostics is what explain --markdown prints") {
  const bool same = runProskill({"explain", "--markdown"}).out ==
                    readFile(PROSKILL_SOURCE_DIR "/docs/diagnostics.md");
  INFO("run `proskill explain --markdown > docs/diagnostics.md`");
  CHECK(same);
}
