#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

using namespace proskill::test;

namespace {

const std::string kIgnoring = "(defskill grip :action (grip) :failure slipped)\n"
                              "(defskill mission :body ((grip)))\n";

Finished check(const TemporaryDirectory& directory, const std::string& option = "--format=short") {
  return run({PROSKILL_PROGRAM, "check", directory.path("main.proskill"), option});
}

std::string textOf(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

} // namespace

TEST_CASE("settings beside the program, or above it, weigh its findings") {
  const TemporaryDirectory directory;
  directory.write("main.proskill", kIgnoring);
  CHECK(check(directory).exitCode == 0);
  directory.write(".proskill.json", R"({"severity": {"PS0708": "error"}})");
  const Finished strict = check(directory);
  CHECK(strict.exitCode == 1);
  CHECK(strict.out.find("error[PS0708]") != std::string::npos);
  directory.write(".proskill.json", R"({"severity": {"PS0708": "off"}})");
  CHECK(check(directory).out.empty());
}

TEST_CASE("settings weigh what is found in a model in Fiacre; its errors stay errors") {
  const TemporaryDirectory directory;
  const auto model = directory.write("m.fcr", "process P [p: sync] is\nstates a\nfrom a p; loop\n"
                                              "component m is port p: sync par P [p] end\nm\n");
  const auto wrong = directory.write("wrong.fcr", "component m is par P end\nm\n");
  const auto checked = [](const std::string& file) {
    return run({PROSKILL_PROGRAM, "check", file, "--format=short"});
  };
  CHECK(checked(model).out.find("warning[PS1303]") != std::string::npos);
  directory.write(".proskill.json", R"({"severity": {"PS1303": "error", "PS1302": "off"}})");
  CHECK(checked(model).exitCode == 1);
  CHECK(checked(wrong).exitCode == 1);
  directory.write(".proskill.json", R"({"severity": {"PS1303": "off"}})");
  CHECK(checked(model).out.empty());
}

TEST_CASE("settings that mean nothing are a mistake, and say which") {
  const TemporaryDirectory directory;
  directory.write("main.proskill", kIgnoring);
  for (const auto& [text, part] :
       {std::pair{R"({"severity": {"PS9999": "off"}})", ":1:15: `PS9999` is not the code"},
        std::pair{R"({"severity": {"PS0708": "loud"}})", "`hint` or `off`"},
        std::pair{"{\n  \"colour\": true\n}", ".proskill.json:2:3: unknown setting `colour`"},
        std::pair{"{", ":1:1: invalid JSON"}}) {
    directory.write(".proskill.json", text);
    const Finished result = check(directory);
    CHECK(result.exitCode == 2);
    CHECK(result.err.find(part) != std::string::npos);
  }
}

TEST_CASE("check --fix writes what one edit fixes, and reports what is left") {
  const TemporaryDirectory directory;
  const std::string file = directory.write("main.proskill", "(defskill grip :action (grip))\n"
                                                            "(defskill mission\n"
                                                            "  :body ((gripp)\n"
                                                            "         (^ 3)))\n");
  const Finished result = check(directory, "--fix");
  CHECK(result.exitCode == 0);
  CHECK(result.err.starts_with("fixed 1 finding in 1 file\n"));
  CHECK(textOf(file) == "(defskill grip :action (grip))\n"
                        "(defskill mission\n"
                        "  :body ((grip)\n"
                        "         (^ 3)))\n");
  CHECK(check(directory, "--fix").err.starts_with("fixed 0 findings in 0 files\n"));
}

TEST_CASE("check --fix joins two `from` of one state of a Fiacre model") {
  const TemporaryDirectory directory;
  const std::string file = directory.write("main.fcr", "process P is\nstates s, t\n"
                                                       "from s\n    to t\n"
                                                       "from s\n    to s\n"
                                                       "from t\n    to s\n\nP\n");
  const Finished result = run({PROSKILL_PROGRAM, "check", "--fix", file});
  CHECK(result.err.starts_with("fixed 1 finding in 1 file\n"));
  CHECK(result.exitCode == 0);
  CHECK(textOf(file).find("select") != std::string::npos);
}

TEST_CASE("check --style tells hints that are quiet otherwise") {
  const TemporaryDirectory directory;
  directory.write("main.proskill", "(defskill Mission :body ((^ 1)))\n");
  CHECK(check(directory).out.empty());
  CHECK(check(directory, "--style").out.find("PS1101") != std::string::npos);
}
