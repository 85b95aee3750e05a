#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>

using namespace proskill::test;
using Json = nlohmann::json;

namespace {

constexpr auto kClean = "(defresource arm)\n(defskill grasp :resources (arm) :action (grasp))\n"
                        "(defskill mission :body ((grasp)))\n";
constexpr auto kMisspelt = "(defskill takeoff :action (takeoff))\n"
                           "(defskill mission\n"
                           "  :body ((takeof)))\n";
constexpr auto kWarned = "(defskill survey :action (survey))\n"
                         "(defskill mission\n"
                         "  :body ((// ((survey)) ((^ 1) (survey)))))\n";

/// Runs `proskill check` on a file with this text, which the output calls `main.proskill`.
Finished check(const std::string& text, std::vector<std::string> options = {}) {
  const TemporaryDirectory directory;
  const std::string file = directory.write("main.proskill", text);
  std::vector<std::string> command{PROSKILL_PROGRAM, "check", file};
  command.insert(command.end(), options.begin(), options.end());
  Finished result = run(command);
  for (std::size_t at; (at = result.out.find(file)) != std::string::npos;)
    result.out.replace(at, file.size(), "main.proskill");
  return result;
}

/// No line has trailing spaces.
bool hasTrailingSpace(const std::string& text) { return text.find(" \n") != std::string::npos; }

} // namespace

TEST_CASE("a clean program says nothing and exits with 0") {
  const Finished result = check(kClean);
  CHECK(result.exitCode == 0);
  CHECK(result.out.empty());
  CHECK(result.err == "nothing to report in 1 file\n");
}

TEST_CASE("an empty file is a clean program") {
  CHECK(check("").exitCode == 0);
  CHECK(check("; nothing yet\n").exitCode == 0);
}

TEST_CASE("an error is shown in its source, with what was probably meant") {
  const Finished result = check(kMisspelt);
  CHECK(result.exitCode == 1);
  CHECK(result.out == "error[PS0201]: unknown skill `takeof`\n"
                      " --> main.proskill:3:11\n"
                      "  |\n"
                      "3 |   :body ((takeof)))\n"
                      "  |           ^^^^^^\n"
                      "  |\n"
                      "  = help: did you mean `takeoff`?\n"
                      "\n");
  CHECK(result.err == "1 error in 1 file\n");
}

TEST_CASE("related places stand in the same picture") {
  const Finished result = check(kWarned);
  CHECK(result.exitCode == 1);
  CHECK(result.out ==
        "warning[PS0423]: `survey` may still be running in another branch; the call waits until it "
        "is free\n"
        " --> main.proskill:3:33\n"
        "  |\n"
        "3 |   :body ((// ((survey)) ((^ 1) (survey)))))\n"
        "  |                ------           ^^^^^^\n"
        "  |                |\n"
        "  |                may run it at the same time\n"
        "\n");
  CHECK(result.err == "1 warning in 1 file\n");
}

TEST_CASE("lines that are left out are dots") {
  const Finished result =
      check("(defresource arm)\n\n\n\n(defresource arm)\n(defskill s :action (s))");
  CHECK(result.out.starts_with("error[PS0220]: a second resource is called `arm`\n"
                               " --> main.proskill:5:14\n"
                               "  |\n"
                               "1 | (defresource arm)\n"
                               "  |              --- first defined here\n"
                               "...\n"
                               "5 | (defresource arm)\n"
                               "  |              ^^^\n"));
}

TEST_CASE("carets stand right below tabs and wide characters") {
  const Finished result =
      check("(defskill s\n\t:action (s \"é漢字e\u0301\")\t:success a\t:failure (b b))\n");
  CHECK(result.out == "error[PS0221]: a second tag is called `b` here\n"
                      " --> main.proskill:2:45\n"
                      "  |\n"
                      "2 |     :action (s \"é漢字e\u0301\")    :success a  :failure (b b))\n"
                      "  |                                                   - ^\n"
                      "  |                                                   |\n"
                      "  |                                                   first defined here\n"
                      "\n");
}

TEST_CASE("what would disturb a terminal is not printed") {
  const Finished result = check("(defresource arm) ; \x1b[2J\n(defresource \x1b[31marm)\n");
  CHECK(result.out.find('\x1b') == std::string::npos);
  CHECK(result.exitCode == 1);
}

TEST_CASE("a mark over several lines is drawn at both ends") {
  const Finished result = check("(defsv n :init 1 :min 0 :max 3)\n"
                                "(defskill m :body ((^ (+ n\n"
                                "                         1))))\n");
  CHECK(result.out == "error[PS0301]: expected a condition, found a natural\n"
                      " --> main.proskill:2:23\n"
                      "  |\n"
                      "2 | (defskill m :body ((^ (+ n\n"
                      "  |                       ^^^^\n"
                      "3 |                          1))))\n"
                      "  |                          ^^\n"
                      "\n");
}

TEST_CASE("of a very long line only what is around the mark is shown") {
  const std::string comment(5000, ';');
  const Finished result =
      check("(defresource arm)" + std::string(3000, ' ') + "(defresource arm)" + comment);
  CHECK(result.out.find("…") != std::string::npos);
  CHECK(result.out.size() < 2000);
  CHECK(result.out.find(":1:3031\n") != std::string::npos);
}

TEST_CASE("related places in other files are shown there") {
  const TemporaryDirectory directory;
  const std::string main =
      directory.write("main.proskill", "(include \"lib.proskill\")\n(defresource arm)\n");
  const std::string lib = directory.write("lib.proskill", "\n(defresource arm)\n");
  const Finished result = run({PROSKILL_PROGRAM, "check", main});
  CHECK(result.out == "error[PS0220]: a second resource is called `arm`\n"
                      " --> " +
                          main +
                          ":2:14\n"
                          "  |\n"
                          "2 | (defresource arm)\n"
                          "  |              ^^^\n"
                          " ::: " +
                          lib +
                          ":2:14\n"
                          "  |\n"
                          "2 | (defresource arm)\n"
                          "  |              --- first defined here\n"
                          "\n");
  CHECK(result.err == "1 error in 2 files\n");
}

TEST_CASE("short format has a line for each finding") {
  const Finished result =
      check(std::string(kMisspelt) + "(defresource a)(defresource a)\n", {"--format", "short"});
  CHECK(result.exitCode == 1);
  CHECK(result.out == "main.proskill:3:11: error[PS0201]: unknown skill `takeof`\n"
                      "main.proskill:4:29: error[PS0220]: a second resource is called `a`\n");
  CHECK(result.err == "2 errors in 1 file\n");
}

TEST_CASE("JSON has places, related places and fixes") {
  const Finished result = check(kMisspelt, {"--format", "json"});
  CHECK(result.exitCode == 1);
  CHECK(result.err.empty());
  const Json report = Json::parse(result.out);
  CHECK(report["version"] == 1);
  CHECK(report["summary"] == Json{{"errors", 1}, {"warnings", 0}, {"hints", 0}, {"files", 1}});
  const Json location{{"file", "main.proskill"},
                      {"begin", {{"line", 3}, {"column", 11}, {"offset", 65}}},
                      {"end", {{"line", 3}, {"column", 17}, {"offset", 71}}}};
  CHECK(report["diagnostics"] ==
        Json::array({{{"code", "PS0201"},
                      {"severity", "error"},
                      {"message", "unknown skill `takeof`"},
                      {"location", location},
                      {"related", Json::array()},
                      {"fixes", Json::array({{{"title", "did you mean `takeoff`?"},
                                              {"location", location},
                                              {"text", "takeoff"}}})}}}));
  CHECK(Json::parse(
            check(kWarned, {"--format", "json"}).out)["diagnostics"][0]["related"][0]["message"] ==
        "may run it at the same time");
}

TEST_CASE("JSON is valid whatever the bytes of the program") {
  const Finished result = check("(defskill \xff\xfe :action (s))\n", {"--format", "json"});
  CHECK(Json::accept(result.out));
  CHECK(result.exitCode == 1);
}

TEST_CASE("SARIF has its rules, and results that point to them") {
  const Finished result = check(kMisspelt, {"--format", "sarif"});
  CHECK(result.exitCode == 1);
  const Json log = Json::parse(result.out);
  CHECK(log["version"] == "2.1.0");
  const Json& sarif = log["runs"][0];
  CHECK(sarif["columnKind"] == "unicodeCodePoints");
  const Json& driver = sarif["tool"]["driver"];
  CHECK(driver["name"] == "proskill");
  REQUIRE(sarif["results"].size() == 1);
  const Json& found = sarif["results"][0];
  CHECK(found["ruleId"] == "PS0201");
  CHECK(driver["rules"][found["ruleIndex"].get<std::size_t>()]["id"] == "PS0201");
  CHECK(found["level"] == "error");
  const Json& physical = found["locations"][0]["physicalLocation"];
  CHECK(physical["region"] ==
        Json{{"startLine", 3}, {"startColumn", 11}, {"endLine", 3}, {"endColumn", 17}});
  const Json& change = found["fixes"][0]["artifactChanges"][0];
  CHECK(change["replacements"][0]["insertedContent"]["text"] == "takeoff");
  for (const Json& rule : driver["rules"]) {
    INFO(rule["id"]);
    CHECK(rule["shortDescription"]["text"].get<std::string>().size() > 5);
    CHECK(rule["defaultConfiguration"]["level"].is_string());
  }
}

TEST_CASE("SARIF names files by valid URIs") {
  const TemporaryDirectory directory;
  const std::string file = directory.write("my robot é.proskill", "(defskill s)");
  const Json log = Json::parse(run({PROSKILL_PROGRAM, "check", "--format", "sarif", file}).out);
  const std::string uri =
      log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"];
  CHECK(uri == "file://" + directory.path() + "/my%20robot%20%C3%A9.proskill");
}

TEST_CASE("hints alone are no findings") {
  const Finished result =
      check("(defskill s :action (s) :start (motion Free))\n", {"--fragment", "--format", "short"});
  CHECK(result.exitCode == 0);
  CHECK(result.out == "main.proskill:1:33: hint[PS0202]: unknown state variable `motion`\n");
  CHECK(check("(defskill s :action (s) :start (motion Free))\n").exitCode == 1);
}

TEST_CASE("colours only where they are wanted") {
  auto coloured = [](const Finished& result) {
    return result.out.find("\x1b[") != std::string::npos;
  };
  CHECK_FALSE(coloured(check(kMisspelt)));
  CHECK(coloured(check(kMisspelt, {"--color", "always"})));
  CHECK_FALSE(coloured(check(kMisspelt, {"--color", "never"})));
}

TEST_CASE("what cannot be read is named, with the reason, and exits with 2") {
  const TemporaryDirectory directory;
  const std::string missing = directory.path("missing.proskill");
  Finished result = run({PROSKILL_PROGRAM, "check", missing});
  CHECK(result.exitCode == 2);
  CHECK(result.err == "error: cannot read `" + missing + "`: no such file or directory\n");

  result = run({PROSKILL_PROGRAM, "check", directory.path()});
  CHECK(result.exitCode == 2);
  CHECK(result.err == "error: cannot read `" + directory.path() + "`: is a directory\n");

  const std::string broken = directory.write("broken.proskill", "(defskill s)");
  result = run({PROSKILL_PROGRAM, "check", "--format", "short", missing, broken});
  CHECK(result.exitCode == 2);
  CHECK(result.out.find("PS0406") != std::string::npos);
}

TEST_CASE("an include that cannot be read is a finding") {
  const Finished result =
      check("(include \"missing.proskill\")\n(include \".\")\n", {"--format", "short"});
  CHECK(result.exitCode == 1);
  CHECK(result.out.find("1:11: error[PS0006]: cannot read `missing.proskill`: no such file or "
                        "directory\n") != std::string::npos);
  CHECK(result.out.find("2:11: error[PS0006]: cannot read `.`: is a directory\n") !=
        std::string::npos);
}

TEST_CASE("a file that another given one includes is seen in that context") {
  const TemporaryDirectory directory;
  const std::string main = directory.write(
      "main.proskill", "(include \"lib.proskill\")\n(defresource arm)\n(defskill m :body ((s)))\n");
  const std::string lib =
      directory.write("lib.proskill", "(defskill s :resources (arm) :action (s))\n");
  CHECK(run({PROSKILL_PROGRAM, "check", lib}).exitCode == 1);
  CHECK(run({PROSKILL_PROGRAM, "check", lib, main}).exitCode == 0);
  CHECK(run({PROSKILL_PROGRAM, "check", main, lib, main}).exitCode == 0);
}

TEST_CASE("what two programs share is told once") {
  const TemporaryDirectory directory;
  directory.write("lib.proskill", "(defskill s)\n");
  const std::string a = directory.write("a.proskill", "(include \"lib.proskill\")\n");
  const std::string b = directory.write("b.proskill", "(include \"lib.proskill\")\n");
  const Finished result = run({PROSKILL_PROGRAM, "check", "--format", "short", a, b});
  CHECK(std::count(result.out.begin(), result.out.end(), '\n') == 1);
  CHECK(result.err == "1 error in 3 files\n");
}

TEST_CASE("no line of a picture ends with spaces") {
  for (auto text : {kMisspelt, kWarned}) CHECK_FALSE(hasTrailingSpace(check(text).out));
}
