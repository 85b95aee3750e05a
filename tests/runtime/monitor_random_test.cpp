#include "runtime/monitor/property_monitors.h"
#include "tests/runtime/run_of.h"
#include "tests/support/random/random_program.h"
#include "tests/support/texts.h"
#include "verify/compile/compile.h"
#include "verify/state/state_layout.h"
#include "verify/trace/simulator.h"
#include "verify/trace/step_description.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cstdlib>

namespace proskill::test::monitor_random_test {

using runtime::Verdict;
using verify::Truth;

namespace {

std::pair<std::uint64_t, std::uint64_t> seeds() {
  const char* given = std::getenv("PROSKILL_MONITOR_SEEDS");
  if (!given) return {0, 250};
  const std::string text = given;
  const auto colon = text.find(':');
  return {std::stoull(text.substr(0, colon)), std::stoull(text.substr(colon + 1))};
}

std::string randomText(std::uint64_t seed) {
  return textOf(randomProgram(seed, {.properties = 4, .scopes = 50}));
}

/// A program with the verifier's answers to its own properties.
struct Judged {
  codegen::Model model;
  std::vector<std::size_t> own; ///< checks
  std::vector<verify::Answer> answers;
};

Judged judgedProgram(const std::string& text) {
  auto model = codegen::generate(programOfText(text), {});
  REQUIRE(model);
  Judged judged{std::move(*model), {}, {}};
  std::vector<verify::Question> questions;
  for (std::size_t i = 0; i < judged.model.checks.size(); ++i) {
    const auto& check = judged.model.checks[i];
    if (check.kind != "property") continue;
    judged.own.push_back(i);
    questions.push_back({check.property, check.fair, check.exempt, check.rests});
  }
  if (questions.empty()) return judged;
  verify::Options options;
  options.limits.classes = 4'000;
  auto result = verify::verify(judged.model.fiacre, judged.model.provenance, questions, options);
  REQUIRE(result);
  judged.answers = std::move(result->answers);
  return judged;
}

/// Occasional interrupts of everything, and frequent events.
std::string interruptions(const runtime::Executable& executable) {
  std::string interrupts;
  std::string events;
  for (const auto& signal : executable.model.signals) {
    if (signal.every) continue;
    auto& to = signal.interrupts ? interrupts : events;
    to += fmt::format("{}\"{}\":[0.5,6]", to.empty() ? "" : ",", signal.name);
  }
  return "{\"interrupts\":{" + interrupts + "},\"events\":{" + events + "}}";
}

/// Follows the steps of a trace of the verified model, and lets monitors read it.
/// \return by property of `questions`; empty if the trace cannot be followed
std::vector<runtime::PropertyMonitors::Decision>
readTrace(const verify::System& system, const std::vector<runtime::Monitored>& properties,
          const verify::Trace& trace) {
  constexpr runtime::Nanoseconds kTick = 1'000; ///< of the trace
  const verify::Simulator simulator(system, trace.scale);
  runtime::PropertyMonitors monitors(system, properties, kTick * trace.scale);
  const auto ignore = [](const auto&) {};
  auto now = simulator.start();
  monitors.start(now.state.data(), ignore);
  for (const auto& step : trace.steps) {
    bool taken = false;
    for (const auto& [id, since] : now.since) {
      verify::StepLog log;
      if (!simulator.isRipe(now, id, step.date)) continue;
      auto next = simulator.take(now, id, step.date, log);
      if (!next || nameOf(system, id, log) != step.transitions.at(0)) continue;
      monitors.step({.before = now.state.data(),
                     .after = next->state.data(),
                     .events = log.events,
                     .date = step.date * kTick},
                    ignore);
      now = std::move(*next);
      taken = true;
      break;
    }
    if (!taken) return {};
  }
  const auto last = trace.steps.empty() ? 0 : trace.steps.back().date;
  monitors.wait(now.state.data(), std::max(trace.end, last) * kTick, ignore);
  return monitors.verdicts();
}

} // namespace

TEST_CASE("no run of a random program contradicts the verifier") {
  std::size_t decided = 0;
  std::size_t settled = 0;
  const auto [first, count] = seeds();
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const auto text = randomText(seed);
    const auto judged = judgedProgram(text);
    if (judged.own.empty()) continue;
    for (const bool environment : {true, false}) {
      const auto executable = executableOf(text, environment);
      if (!environment && executable->model.fiacre.processes.empty()) continue;
      if (!environment && text.find("defenvironment") != std::string::npos) continue;
      const auto platform = environment ? std::string() : interruptions(*executable);
      for (std::uint64_t run = 0; run < 3; ++run) {
        const auto ran = test::runOf(*executable, seed + 1000 * run, "", platform, 30);
        for (std::size_t i = 0; i < judged.own.size(); ++i) {
          const auto truth = judged.answers[i].truth;
          const auto verdict = ran.result.verdicts.at(i).verdict;
          const bool reaches = executable->properties[i].isGood;
          decided += verdict == Verdict::NotYet ? 0 : 1;
          settled += truth == Truth::Unknown ? 0 : 1;
          if (truth != Truth::True) continue;
          INFO("seed " << seed << " run " << run << " environment " << environment << " wish " << i
                       << "\n"
                       << text << ran.text());
          CHECK(verdict != (reaches ? Verdict::True : Verdict::False));
        }
      }
    }
  }
  CHECK(decided > count);
  CHECK(settled > count);
}

TEST_CASE("monitors find what the verifier's traces show") {
  std::size_t read = 0;
  std::size_t violated = 0;
  const auto [first, count] = seeds();
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const auto text = randomText(seed);
    auto judged = judgedProgram(text);
    auto& model = judged.model;
    const auto questions = runtime::addNegations(model);
    auto compiled = verify::compile(model.fiacre, model.provenance, questions);
    REQUIRE(compiled);
    const auto properties = runtime::monitored(model, compiled->goals);
    const auto system = verify::withStateLayout(std::move(compiled->system));
    for (std::size_t i = 0; i < judged.own.size(); ++i) {
      const auto& answer = judged.answers[i];
      if (answer.truth != Truth::False || !answer.trace) continue;
      const auto verdicts = readTrace(system, properties, *answer.trace);
      if (verdicts.empty()) continue;
      ++read;
      const auto& check = model.checks[judged.own[i]];
      const auto& pattern = model.fiacre.properties[check.property].pattern;
      const bool isFinite = !isAboutEndlessRuns(pattern) && !answer.trace->loop &&
                            whyNotMonitored(properties[judged.own[i]]).empty();
      const bool reaches = properties[judged.own[i]].isGood;
      const auto verdict = verdicts.at(judged.own[i]).verdict;
      INFO("seed " << seed << " " << check.name << " " << toString(verdict) << "\n" << text);
      CHECK(verdict != (reaches ? Verdict::False : Verdict::True));
      if (!isFinite) continue;
      ++violated;
      CHECK(verdict == (reaches ? Verdict::True : Verdict::False));
    }
  }
  CHECK(read > count / 4);
  CHECK(violated > count / 8);
}

} // namespace proskill::test::monitor_random_test
