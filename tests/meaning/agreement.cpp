#include "tests/meaning/agreement.h"

#include "tests/meaning/replay.h"
#include "tests/meaning/timed/duration.h"
#include "tests/meaning/timed/pattern.h"
#include "tests/meaning/verdicts.h"
#include "tests/support/texts.h"

#include <fmt/format.h>

namespace proskill::meaning {
namespace {

/// Some formulas have automata with which a small program has millions of classes.
constexpr std::uint64_t kMostClasses = 200'000;
constexpr std::string_view kLimitMet = "the limit of classes was reached";

std::string wordOf(verify::Truth truth) {
  switch (truth) {
  case verify::Truth::True: return "true";
  case verify::Truth::False: return "false";
  case verify::Truth::Unknown: break;
  }
  return "unknown";
}

std::vector<verify::Question> questionsOf(const codegen::Model& model) {
  std::vector<verify::Question> questions;
  for (const auto& check : model.checks)
    questions.push_back({check.property, check.fair, check.exempt, check.rests});
  return questions;
}

void compareTrace(const Replays& replays, const verify::Answer& answer, Comparison& comparison) {
  if (!answer.trace) return;
  ++comparison.traces;
  const auto why = replays.whyNoRun(*answer.trace);
  if (!why) return;
  comparison.kind = "trace";
  comparison.disagreement = "  the engine's trace is no run: " + *why;
}

/// \return whether the engine has met the limit of this test
bool isLimited(const verify::Answer& answer, Comparison& comparison) {
  const bool met = answer.truth == verify::Truth::Unknown && answer.reason == kLimitMet;
  comparison.limited += met ? 1 : 0;
  return met;
}

void compareTruth(bool expected, const verify::Answer& answer, Comparison& comparison) {
  if (isLimited(answer, comparison)) return;
  ++comparison.questions;
  if (answer.truth == (expected ? verify::Truth::True : verify::Truth::False)) return;
  comparison.kind = "engine " + wordOf(answer.truth) + " " + answer.reason;
  comparison.disagreement = fmt::format("  engine:      {} {}\n  interpreter: {}",
                                        wordOf(answer.truth), answer.reason, expected);
}

std::string wordsOf(const verify::Duration& duration) {
  if (!duration.happens) return "never";
  if (!duration.bounded) return "unbounded";
  return std::to_string(duration.value.value) + (duration.value.strict ? ", excluded" : "");
}

/// To the interpreter, a time that is too long for it looks like an unbounded one.
void compareDuration(const verify::Duration& expected, const verify::Answer& answer,
                     Comparison& comparison) {
  if (isLimited(answer, comparison)) return;
  ++comparison.questions;
  ++comparison.scopes;
  const auto& got = answer.duration;
  const bool isLong = expected.happens && !expected.bounded && got && got->happens;
  if (isLong && (!got->bounded || got->value.value >= kMeasured)) return;
  if (got == expected) return;
  comparison.kind = "another time";
  comparison.disagreement = fmt::format("  engine:      {}\n  interpreter: {}",
                                        got ? wordsOf(*got) : answer.reason, wordsOf(expected));
}

/// Compares the engine's answers with these options.
void compareAnswers(const Script& script, const codegen::Model& model, const Verdicts& verdicts,
                    const Replays& replays, const verify::Options& options,
                    Comparison& comparison) {
  const auto result = verify::verify(model.fiacre, model.provenance, questionsOf(model), options);
  if (!result) {
    comparison.refusal = "the engine cannot run it: " + result.error().message;
    return;
  }
  for (std::size_t i = 0; i < model.checks.size(); ++i) {
    const auto& check = model.checks[i];
    const auto& answer = result->answers[i];
    compareTrace(replays, answer, comparison);
    const auto expected = verdicts.isTrue(check, model.provenance.origins[check.origin]);
    if (expected && !comparison.disagreement) compareTruth(*expected, answer, comparison);
    const auto time = verdicts.duration(check);
    if (time && !comparison.disagreement) compareDuration(*time, answer, comparison);
    if (expected && check.kind == "property")
      comparison.scopes += hasScopeOrTime(script.program->properties.find(check.subject)->node());
    if (!comparison.disagreement) continue;
    comparison.kind = check.kind + ", " + comparison.kind;
    comparison.disagreement =
        fmt::format("{} ({})\n{}", check.name, check.description, *comparison.disagreement);
    return;
  }
}

Comparison compare(const Script& script, const codegen::Model& model, std::size_t limit,
                   const verify::Options& options) {
  Comparison comparison;
  const Runs runs(script, limit);
  comparison.situations = runs.nodes().size();
  comparison.tooLarge = !runs.complete();
  if (comparison.tooLarge) return comparison;
  const Verdicts verdicts(script, runs);
  const Replays replays(script, model.unit);
  verify::Options asked = options;
  asked.limits.classes = kMostClasses;
  for (const auto& [process, _] : model.obliged) asked.obliged.insert(process);
  compareAnswers(script, model, verdicts, replays, asked, comparison);
  return comparison;
}

} // namespace

Comparison compare(const std::vector<test::Form>& forms, std::size_t limit,
                   const verify::Options& options, codegen::Edition edition) {
  const auto program = test::programOfText(test::textOf(forms));
  if (!test::isWellFormed(program)) return {};
  auto script = scriptOf(program);
  const auto model = codegen::generate(program, {.edition = edition});
  if (!script || !model) return {};
  const auto comesByItself = [](const syntax::Event* event) { return event->every.has_value(); };
  const auto isWatched = [](const syntax::StateVariable* variable) {
    return variable->isNatural() || variable->transitionsKind == syntax::Transitions::Listed;
  };
  script->eventsMakeSteps = edition == codegen::Edition::Expanded &&
                            (std::ranges::any_of(script->events, comesByItself) ||
                             std::ranges::any_of(script->variables, isWatched));
  return compare(*script, *model, limit, options);
}

std::string smallest(std::vector<test::Form> program, std::size_t limit,
                     const verify::Options& options, codegen::Edition edition) {
  const auto small = test::minimise(std::move(program), [&](const auto& forms) {
    return compare(forms, limit, options, edition).disagreement.has_value();
  });
  return test::textOf(small) + *compare(small, limit, options, edition).disagreement;
}

} // namespace proskill::meaning
