#include "tests/cli/forbidden_move.h"
#include "tests/support/run.h"
#include "tests/support/stand_ins.h"
#include "tests/where.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace proskill::test::tina_test {

using Json = nlohmann::json;

namespace {

const std::string kProperty = "lamp.no_forbidden_transition";

std::string contents(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Verifies the one property of the program above with fake Tina tools.
struct Scene {
  Scene() : program(files.write("lamp.proskill", kForbiddenMove)) {
    tools.formulas("op p = [] - x;\np;\n");
    tools.verdicts("FALSE\n");
    tools.graph(graph());
  }

  [[nodiscard]] std::string graph() const {
    const auto path = files.path("graph.txt");
    REQUIRE(
        run({PROSKILL_PROGRAM, "verify", program, "--backend", "tina", "--graph", path}).exitCode ==
        0);
    return contents(path);
  }
  Finished verify(std::vector<std::string> arguments, RunOptions options = {}) const {
    arguments.insert(arguments.begin(),
                     {PROSKILL_PROGRAM, "verify", program, "--property", kProperty});
    options.environment = {tools.searchPath(), "CC=" + tools.path("cc")};
    return run(arguments, options);
  }
  [[nodiscard]] Finished both() const {
    return verify({"--backend", "both", "--difference", files.path("difference.md")});
  }

  TemporaryDirectory files;
  StandIns tools;
  std::string program;
};

} // namespace

TEST_CASE("verify --backend tina shows the same trace as the engine does") {
  const Scene scene;
  const auto tina = scene.verify({"--backend", "tina", "--format", "json"});
  INFO(tina.err);
  CHECK(tina.exitCode == 1);
  auto report = Json::parse(tina.out);
  CHECK(report["backend"] == "tina");
  const auto engine = Json::parse(scene.verify({"--format", "json"}).out);
  CHECK_FALSE(engine.contains("backend"));
  REQUIRE(report["properties"].size() == 1);
  const auto& row = report["properties"][0];
  CHECK(row["verdict"] == "violated");
  const auto& steps = row["trace"]["steps"];
  REQUIRE(steps.size() > 1);
  for (const auto& step : steps) CHECK(step["location"]["file"] == scene.program);
  // in the edition for Tina, the move and the step that reports it are separate
  const auto& moves = engine["properties"][0]["trace"]["steps"].back()["changes"];
  CHECK(steps[steps.size() - 2]["changes"] == moves);
  CHECK(steps.back()["earliest"]["exact"] == "1");
  CHECK(steps.back()["latest"]["exact"] == "2");
  const auto text = scene.verify({"--backend", "tina"});
  CHECK_THAT(text.out, Catch::Contains("`lamp` makes no forbidden move: violated") &&
                           Catch::Contains("lamp: Off → Broken"));
}

TEST_CASE("verify --backend tina says what is missing, and runs nothing") {
  Scene scene;
  scene.tools.remove("selt");
  scene.tools.replace("frac", "touch \"$here/ran\"");
  const auto result = scene.verify({"--backend", "tina"});
  CHECK(result.exitCode == 2);
  CHECK(result.out.empty());
  CHECK_THAT(result.err,
             Catch::Contains("`selt` is missing: the model checker of the Tina toolbox, "
                             "https://projects.laas.fr/tina/"));
  CHECK_FALSE(std::filesystem::exists(scene.tools.path("ran")));
  const auto named =
      scene.verify({"--backend", "tina", "--selt", "/no/such/selt", "--cc", "no-such-cc"});
  CHECK_THAT(named.err,
             Catch::Contains("`/no/such/selt` is not an executable program") &&
                 Catch::Contains("`cc` is missing: `no-such-cc` is not an executable program"));
}

TEST_CASE("verify --backend tina is for models in Fiacre, too") {
  StandIns tools;
  const TemporaryDirectory files;
  const auto model = files.write("m.fcr", "process p is states a, b from a to b\n"
                                          "component main is par * in p end main\n"
                                          "property q is absent main/1/state b\nassert q\n");
  tools.formulas("op q = x;\nq;\n");
  tools.verdicts("FALSE\n");
  tools.counterexample("p_1_t0@7\n", "");
  const auto result =
      run({PROSKILL_PROGRAM, "verify", model, "--backend", "tina", "--cc", tools.path("cc")},
          {.environment = {tools.searchPath()}});
  INFO(result.err);
  CHECK(result.exitCode == 1);
  CHECK_THAT(result.out, Catch::Contains(model + ":1:"));
}

TEST_CASE("verify --backend tina takes what is not understood for an error, with the output") {
  Scene scene;
  scene.tools.verdicts("nobody knows\n");
  const auto result = scene.verify({"--backend", "tina"});
  CHECK(result.exitCode == 2);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::Contains("not understood") && Catch::Contains("nobody knows"));
}

TEST_CASE("verify --backend tina ends at its limit, inconclusive") {
  Scene scene;
  scene.tools.replace("sift", "sleep 600");
  const auto result = scene.verify({"--backend", "tina", "--time-limit", "0.2"});
  CHECK(result.exitCode == 3);
  CHECK_THAT(result.out, Catch::Contains("inconclusive (the time limit was reached, in `"));
}

TEST_CASE("verify --backend tina, interrupted, leaves no process and no file behind") {
  Scene scene;
  // the fake tool interrupts the run itself: its parent's parent is the program
  scene.tools.replace("sift", "pwd > \"$here/place\"; parent() { cut -d' ' -f4 /proc/$1/stat; }; "
                              "kill -INT $(parent $(parent $$)); sleep 600");
  const auto result = scene.verify({"--backend", "tina"});
  CHECK(result.exitCode == 3);
  CHECK_THAT(result.out, Catch::Contains("inconclusive (cancelled)"));
  auto place = contents(scene.tools.path("place"));
  REQUIRE(!place.empty());
  place.pop_back();
  CHECK_FALSE(std::filesystem::exists(place));
}

TEST_CASE("verify --backend tina --keep leaves the files, and --save-traces the traces") {
  const Scene scene;
  const auto kept = scene.files.path("kept");
  const auto traces = scene.files.path("traces");
  CHECK(scene.verify({"--backend", "tina", "--keep", kept, "--save-traces", traces}).exitCode == 1);
  CHECK_THAT(contents(kept + "/model.fcr"), Catch::Contains("assert lamp_no_forbidden_transition"));
  CHECK(std::filesystem::exists(kept + "/model.txt"));
  CHECK(std::filesystem::exists(traces + "/" + kProperty + ".txt"));
  CHECK(scene.verify({"--backend", "tina", "--keep", kept}).exitCode == 2);
}

TEST_CASE("verify --backend both is the engine's report where Tina agrees") {
  const Scene scene;
  const auto result = scene.both();
  INFO(result.out << result.err);
  CHECK(result.exitCode == 1);
  CHECK_THAT(result.out, Catch::Contains("violated"));
  CHECK(result.err == "the engine and Tina agree on 1 of 1 properties\n");
  CHECK_FALSE(std::filesystem::exists(scene.files.path("difference.md")));
}

TEST_CASE("verify --backend both writes a bug report where Tina does not agree") {
  Scene scene;
  scene.tools.verdicts("TRUE\n");
  const auto result = scene.both();
  CHECK(result.exitCode == 4);
  CHECK_THAT(result.err, Catch::Contains("the engine and Tina differ: " + kProperty));
  const auto report = contents(scene.files.path("difference.md"));
  CHECK_THAT(report, Catch::Contains("| " + kProperty + " | violated | holds |") &&
                         Catch::Contains("- ProSkill ") && Catch::Contains("(defskill kick") &&
                         Catch::Contains("assert lamp_no_forbidden_transition") &&
                         Catch::Contains("lamp: Off → Broken") && Catch::Contains("/selt -q -b") &&
                         Catch::Contains("TRUE"));
  CHECK(scene.both().exitCode == 4);
  CHECK(std::filesystem::exists(scene.files.path("difference-2.md")));
}

TEST_CASE("verify --backend both reports a model that the tools refuse, and a trace that is none") {
  Scene scene;
  SECTION("refused") {
    scene.tools.replace("frac", "echo 'line 12: syntax error' >&2; exit 1");
    CHECK(scene.both().exitCode == 4);
    CHECK_THAT(
        contents(scene.files.path("difference.md")),
        Catch::Contains("| (the model) | can be explored | `frac` ended with exit code 1 |") &&
            Catch::Contains("line 12: syntax error"));
  }
  SECTION("no trace of the model's") {
    scene.tools.graph("kts x\n1 nodes\n0 edges\n\nstate 0\nprops\ntrans\n");
    CHECK(scene.both().exitCode == 4);
    CHECK_THAT(
        contents(scene.files.path("difference.md")),
        Catch::Contains("violated, but no trace: no state of Tina's graph shows the violation"));
  }
}

TEST_CASE("what is added to a program goes to Tina, and comes back, as what it has itself") {
  Scene scene;
  scene.tools.formulas("op p = [] - x;\np;\nop q = [] - y;\nq;\n");
  scene.tools.verdicts("FALSE\nFALSE\n");
  const std::vector<std::string> added{
      "--property",
      "broken",
      "--format",
      "json",
      "--properties",
      scene.files.write("more.fcr",
                        "property broken is absent model/value (lamp = Broken)\nassert broken\n"),
      "--environment",
      scene.files.write("nobody.fcr", "process nobody is\nstates idle\n")};
  const auto verify = [&](std::vector<std::string> words) {
    words.insert(words.end(), added.begin(), added.end());
    return scene.verify(words);
  };
  const auto kept = scene.files.path("kept");
  const auto tina = verify({"--backend", "tina", "--keep", kept});
  INFO(tina.err);
  CHECK(tina.exitCode == 1);
  const auto asked = contents(kept + "/model.fcr");
  CHECK_THAT(asked, Catch::Contains("property broken is") && Catch::Contains("process nobody is"));
  const auto report = Json::parse(tina.out);
  REQUIRE(report["properties"].size() == 2);
  const auto& row = report["properties"][1];
  CHECK(row["name"] == "broken");
  CHECK(row["verdict"] == "violated");
  CHECK(row["trace"]["steps"].back()["location"]["file"] == scene.program);
  CHECK(verify({"--backend", "both"}).exitCode == 1);
}

} // namespace proskill::test::tina_test
