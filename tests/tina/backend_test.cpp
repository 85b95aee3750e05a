#include "tests/tina/scene.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <sys/resource.h>

using namespace proskill;
using namespace proskill::test;
using verify::Truth;

TEST_CASE("verdicts are those of selt, traces those of its scenario, replayed with dates") {
  Scene scene;
  scene.programs.counterexample("# to done\nplay__it_1_t0@1.5 play__it_1_t0@1\nplay__it_1_t1@0\n",
                                "FALSE\n");
  scene.programs.replace("ktzio", "exit 1"); // not needed
  const auto result = scene.result();
  checkTrace(result.answers[0]);
  CHECK(result.answers[1].truth == Truth::True);
  CHECK_FALSE(result.answers[1].trace.has_value());
  checkTrace(result.answers[2]);
  CHECK(result.exploration.classes == 5);
  CHECK(result.exploration.complete);
}

TEST_CASE("a scenario may go on behind the violation, and spell names with one underscore") {
  Scene scene;
  scene.programs.counterexample("play_it_1_t0 play_it_1_t0 play_it_1_t1", "FALSE\n");
  checkTrace(scene.result().answers[0]);
}

TEST_CASE("transitions that frac numbers otherwise are found by who takes part in them") {
  Scene scene;
  scene.programs.counterexample("play__it_1_t7 play__it_1_t7 play__it_1_t8", "FALSE\n");
  checkTrace(scene.result().answers[0]);
}

TEST_CASE("without a scenario the trace is read from what selt prints") {
  Scene scene;
  scene.programs.counterexample("", "FALSE\n  state 0: main_1_v\n  -play__it_1_t0->\n  state 1:\n"
                                    "  -play__it_1_t0->\n  state 2:\n  -play__it_1_t1->\n"
                                    "  state 3:\n");
  scene.programs.replace("ktzio", "exit 1");
  checkTrace(scene.result().answers[2]);
}

TEST_CASE("without any of these the way is searched in the graph that ktzio writes") {
  Scene scene;
  scene.programs.counterexample("", "FALSE\n");
  const auto result = scene.result();
  checkTrace(result.answers[0]);
  checkTrace(result.answers[2]);
}

TEST_CASE("a counterexample that the model does not have is told, and leaves the verdict") {
  Scene scene;
  scene.programs.counterexample("play__it_1_t1", "FALSE\n");
  auto graph = scene.graphText();
  graph.replace(graph.rfind("play__it_1_t1/"), 14, "other__it_1_t1/");
  scene.programs.graph(graph);
  const auto answer = scene.result().answers[0];
  CHECK(answer.truth == Truth::False);
  CHECK_FALSE(answer.trace.has_value());
  CHECK_THAT(answer.reason, Catch::StartsWith("no trace: `other__it_1_t1` is not possible"));
}

TEST_CASE("processes that frac adds to observe timed properties are no hindrance to a trace") {
  Scene scene;
  scene.programs.counterexample("watch__1_1_t0 play__it_1_t0 watch__1_1_t2_play__it_1_t0 "
                                "play__it_1_t1_watch__1_1_t1",
                                "FALSE\n");
  checkTrace(scene.result().answers[0]);
  scene.programs.counterexample("", "FALSE\n");
  scene.programs.remove("scenario");
  scene.programs.graph("state 0\nprops watch__1_1_sa play__it_1_smove\ntrans watch__1_1_t0/1\n\n"
                       "state 1\nprops watch__1_1_sb play__it_1_smove\ntrans play__it_1_t0/2\n\n"
                       "state 2\nprops watch__1_1_sb play__it_1_smove play__it_1_vn\n"
                       "trans watch__1_1_t2_play__it_1_t0/3\n\n"
                       "state 3\nprops play__it_1_smove play__it_1_vn*2\n"
                       "trans play__it_1_t1/4\n\n"
                       "state 4\nprops play__it_1_sdone play__it_1_vn*2\ntrans\n");
  checkTrace(scene.result().answers[0]);
}

TEST_CASE("what a tool says that is not understood is a failure that shows it, never a verdict") {
  Scene scene;
  SECTION("selt") {
    scene.programs.verdicts("FALSE\nperhaps\nFALSE\n");
    const auto text = tina::explain(scene.failure());
    CHECK_THAT(text, Catch::Contains("verdicts of `selt` on 3 formulas are not understood"));
    CHECK_THAT(text, Catch::Contains("perhaps"));
  }
  SECTION("sift") {
    scene.programs.counts("all went well\n");
    CHECK_THAT(tina::explain(scene.failure()),
               Catch::Contains("the output of `sift` on its graph") &&
                   Catch::Contains("all went well"));
  }
  SECTION("a graph that is not whole") {
    scene.programs.counts("5 classe(s), 4 marking(s), 2 domain(s), 3 transition(s)\naborted\n");
    CHECK(scene.failure().message == "`sift` did not explore the whole graph");
  }
  SECTION("frac's formulas") {
    scene.programs.formulas("impossible;\n");
    CHECK_THAT(scene.failure().message, Catch::Contains("1 formulas for 3 properties"));
  }
  SECTION("ktzio") {
    scene.programs.graph(scene.graphText() + "\nsegmentation\n");
    CHECK_THAT(scene.failure().message, Catch::Contains("not understood: segmentation"));
  }
}

TEST_CASE("a tool that fails is a failure with its words and how it ended") {
  Scene scene;
  SECTION("errors in the model") {
    scene.programs.replace("frac", "echo 'line 3: type error' >&2; exit 2");
    const auto failure = scene.failure();
    CHECK(failure.message == "`frac` ended with exit code 2");
    CHECK_THAT(tina::explain(failure), Catch::Contains("line 3: type error"));
    CHECK_THAT(failure.model, Catch::Contains("process play_it is"));
  }
  SECTION("frac writes nothing") {
    scene.programs.replace("frac", "exit 0");
    CHECK_THAT(scene.failure().message, Catch::Contains("model.tts/model.ltl is missing"));
  }
  SECTION("a signal") {
    scene.programs.replace("sift", "kill -11 $$");
    CHECK(scene.failure().message == "`sift` was ended by signal 11 (Segmentation fault)");
  }
  SECTION("a full disk") {
    scene.programs.replace("sift", "cat \"$here/counts\" > /dev/full");
    CHECK_THAT(tina::explain(scene.failure()), Catch::Contains("No space left on device"));
  }
  SECTION("more output than anybody reads") {
    scene.programs.replace("selt", "exec yes TRUE");
    const auto failure = scene.failure();
    CHECK(failure.message == "`selt` wrote too much output and was stopped");
    CHECK(tina::explain(failure).size() < 10'000);
  }
  SECTION("memory, where none is limited") {
    scene.programs.replace("sift", "echo 'out of memory' >&2; exit 1");
    CHECK(scene.failure().message == "`sift` ended with exit code 1");
  }
}

TEST_CASE("a model that cannot be written is a failure before anything runs") {
  Scene scene;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit none{0, before.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &none);
  const auto outcome = scene.run();
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_DFL);
  REQUIRE_FALSE(outcome.has_value());
  CHECK_THAT(outcome.error().message,
             Catch::EndsWith("model.fcr cannot be written: File too large"));
  CHECK(outcome.error().calls.empty());
}

TEST_CASE("a limit leaves verdicts open and says which") {
  Scene scene;
  tina::Options options;
  std::atomic<bool> cancelled{false};
  std::string reason;
  SECTION("time") {
    options.limits.seconds = 0;
    scene.programs.replace("frac", "sleep 600");
    reason = "the time limit was reached, in `frac`";
  }
  SECTION("memory") {
    options.limits.bytes = 512 << 20;
    scene.programs.replace("sift", "echo 'out of memory' >&2; exit 1");
    reason = "the memory limit was reached, in `sift`";
  }
  SECTION("classes") {
    options.limits.classes = 5;
    scene.programs.replace("sift", "echo \"$@\" | grep -q -- '-c 5' && : > model.ktz && cat "
                                   "\"$here/counts\"");
    reason = "the limit of classes was reached";
  }
  SECTION("the user") {
    options.cancelled = &cancelled;
    options.progress = [&](const tina::Progress& now) {
      cancelled = now.tool == "sift" && now.line == "12 classes";
    };
    scene.programs.replace("sift", "echo '12 classes'; sleep 600");
    reason = "cancelled";
  }
  const auto result = scene.result(options);
  for (const auto& answer : result.answers) {
    CHECK(answer.truth == Truth::Unknown);
    CHECK(answer.reason == reason);
  }
  CHECK_FALSE(result.exploration.complete);
  CHECK(result.exploration.stopped == reason);
}

TEST_CASE("a limit that is met while traces are made leaves the verdicts as they are") {
  Scene scene;
  tina::Options options;
  std::atomic<bool> cancelled{false};
  options.cancelled = &cancelled;
  options.progress = [&](const tina::Progress& now) { cancelled = now.line == "tracing"; };
  scene.programs.replace("selt", "case \"$*\" in *-S*) echo tracing; sleep 600;; esac; "
                                 "cat \"$here/verdicts\"");
  const auto result = scene.result(options);
  CHECK(result.answers[0].truth == Truth::False);
  CHECK(result.answers[1].truth == Truth::True);
}

TEST_CASE("deadlocks of which some are allowed are told by the engine on Tina's graph") {
  StandIns programs;
  programs.formulas("op p = [] - dead;\np;\n");
  programs.verdicts("FALSE\n");
  auto parsed = test::model("process p is states a, b from a to b\n"
                            "component main is par * in p end main\n"
                            "property p is deadlockfree\nassert p");
  std::ostringstream text;
  tina::writeKtzText(text, verify::stateGraph(parsed.program, verify::GraphKind::Classes).value(),
                     "main");
  programs.graph(text.str());
  const auto answer = [&](const std::string& allowed) {
    parsed.program.properties[0].pattern.operands = {
        {.kind = fiacre::ObservableKind::State, .path = {1}, .name = allowed}};
    tina::Options options;
    options.tools = toolsOf(programs);
    auto outcome = tina::verify(parsed.program, parsed.provenance, {{0}}, options);
    if (!outcome) FAIL(tina::explain(outcome.error()));
    return outcome->result.answers[0];
  };
  CHECK(answer("b").truth == Truth::True);
  CHECK(answer("a").truth == Truth::False);
  CHECK(answer("a").trace.value().steps.size() == 1);
}

TEST_CASE("strong classes are for models in which some transitions go before others") {
  StandIns programs;
  programs.replace("sift", "echo \"$@\" >&2; exit 1");
  const auto asked = [&](const std::string& priority) {
    const auto parsed = test::model("process p [a: sync, b: sync] is states s from s select a; "
                                    "to s [] b; to s end\n"
                                    "component main is port a: sync, b: sync " +
                                    priority + " par * in p [a, b] end main\n");
    tina::Options options;
    options.tools = toolsOf(programs);
    const auto outcome = tina::verify(parsed.program, parsed.provenance, {}, options);
    REQUIRE_FALSE(outcome.has_value());
    return outcome.error().calls.back().err;
  };
  CHECK(asked("") == "-W model.tts model.ktz\n");
  CHECK(asked("priority a > b") == "-S model.tts model.ktz\n");
}

TEST_CASE("files are kept where that is asked for, in a fresh directory") {
  Scene scene;
  const test::TemporaryDirectory files;
  tina::Options options;
  options.keep = files.path("kept");
  static_cast<void>(scene.result(options));
  for (const auto* name : {"model.fcr", "model.tts/model.ltl", "model.ktz", "trace_1.ltl"})
    CHECK(std::filesystem::exists(files.path("kept") + "/" + name));
  CHECK_THAT(scene.failure(options).message, Catch::Contains("is not empty"));
}

TEST_CASE("the tools are asked the questions alone, and answers are given to the right ones") {
  Scene scene;
  scene.programs.formulas("op small = [] s;\nop ends = [] - e;\nsmall;\nends;\n");
  scene.programs.verdicts("TRUE\nFALSE\n");
  tina::Options options;
  options.tools = toolsOf(scene.programs);
  const auto outcome =
      tina::verify(scene.parsed.program, scene.parsed.provenance, {{2}, {1}}, options);
  if (!outcome) FAIL(tina::explain(outcome.error()));
  CHECK(outcome->result.answers[0].truth == Truth::False);
  CHECK(outcome->result.answers[1].truth == Truth::True);
  CHECK(outcome->model.find("impossible") == std::string::npos);
  CHECK(outcome->model.find("assert small") < outcome->model.find("assert ends"));
}

TEST_CASE("what is missing is said, each with how to get it") {
  StandIns programs;
  const auto find = [&](const tina::ToolChoice& choice) {
    return tina::findTools(choice, [&](const std::string& name) -> std::optional<std::string> {
      if (name == "PATH") return programs.path() + ":/no/such/place";
      if (name == "PROSKILL_SELT") return programs.path("renamed");
      return std::nullopt;
    });
  };
  programs.replace("renamed", "");
  const auto whole = find({});
  REQUIRE(whole.has_value());
  CHECK(whole->selt == programs.path("renamed"));
  CHECK(whole->fraclib.filename() == "lib"); // in the directory of frac
  programs.remove("sift");
  programs.replace("tina", "");
  REQUIRE(find({}).has_value());
  CHECK(find({})->builder == programs.path("tina"));
  programs.remove("tina");
  programs.remove("ktzio");
  const auto partly = find({.frac = "frac-2.8", .fraclib = "/no/lib"});
  REQUIRE_FALSE(partly.has_value());
  CHECK(partly.error().size() == 4);
  CHECK(partly.error()[0] == "`frac` is missing: `frac-2.8` is not an executable program");
  CHECK_THAT(partly.error()[1], Catch::Contains("--sift or --tina") &&
                                    Catch::Contains("https://projects.laas.fr/tina/"));
  CHECK_THAT(partly.error()[2], Catch::Contains("Name it with --ktzio or PROSKILL_KTZIO"));
  CHECK(partly.error()[3] == "FRACLIB is missing: `/no/lib` is not a directory");
}
