#include "tests/support/text_model.h"

#include "fiacre/check/check.h"
#include "fiacre/syntax/parse.h"

#include <stdexcept>

namespace proskill::test {

namespace {

fiacre::Parsed read(const std::string& text, const std::string& pattern) {
  const auto whole = text + "\nmain\nproperty p is " + pattern + "\nassert p";
  auto parsed = fiacre::parse(whole);
  for (const auto& problem : parsed.problems)
    throw std::runtime_error(problem.message + "\n" + whole);
  for (const auto& problem : fiacre::check(parsed.program))
    throw std::runtime_error(problem.place + ": " + problem.message + "\n" + whole);
  return parsed;
}

verify::Answer answer(const fiacre::Parsed& parsed, const verify::Options& options = {}) {
  auto result = verify::verify(parsed.program, parsed.provenance, {{0}}, options);
  if (!result) throw std::runtime_error(result.error().message);
  auto& given = result->answers[0];
  if (given.truth == verify::Truth::Unknown) throw std::runtime_error("unknown: " + given.reason);
  if (given.trace.has_value() != (given.truth == verify::Truth::False))
    throw std::runtime_error("a trace goes with what is false");
  return std::move(given);
}

/// Number of answers from parts that are asked first, without a reduction.
std::uint64_t answersOfParts(const fiacre::Parsed& parsed, verify::Reduction without) {
  verify::Options options;
  options.classesBeforeSlices = 0;
  options.classesOfLedSearches = 0; // no other search answers before them
  options.reductions.erase(without);
  const auto result = verify::verify(parsed.program, parsed.provenance, {{0}}, options);
  return result ? result->exploration.sliced : 0;
}

} // namespace

bool Text::isFalse(const std::string& pattern) const {
  const auto parsed = read(text, pattern);
  verify::Options plain;
  plain.reductions.clear();
  const auto truth = answer(parsed).truth;
  if (answer(parsed, plain).truth != truth)
    throw std::runtime_error("reductions change the answer");
  verify::Options slicesFirst;
  slicesFirst.classesBeforeSlices = 0;
  if (answer(parsed, slicesFirst).truth != truth)
    throw std::runtime_error("slices change the answer");
  slicesFirst.reductions = {verify::Reduction::Refinement};
  if (answer(parsed, slicesFirst).truth != truth)
    throw std::runtime_error("refinement changes the answer");
  return truth == verify::Truth::False;
}

std::uint64_t Text::sliced(const std::string& pattern) const {
  return answersOfParts(read(text, pattern), verify::Reduction::Refinement);
}

std::uint64_t Text::refined(const std::string& pattern) const {
  return answersOfParts(read(text, pattern), verify::Reduction::Slices);
}

verify::Trace Text::trace(const std::string& pattern) const {
  return answer(read(text, pattern)).trace.value();
}

std::string Text::error() const {
  auto parsed = read(text, "deadlockfree");
  parsed.program.properties[0].pattern = {.kind = fiacre::PatternKind::NoError};
  verify::Options plain;
  plain.reductions.clear();
  const auto found = answer(parsed);
  if (answer(parsed, plain).truth != found.truth)
    throw std::runtime_error("reductions change the answer");
  plain.reductions = {verify::Reduction::Refinement};
  plain.classesBeforeSlices = 0;
  if (answer(parsed, plain).truth != found.truth)
    throw std::runtime_error("refinement changes the answer");
  if (!found.trace) return {};
  const auto& step = found.trace->steps.back();
  const auto& origin = parsed.provenance.origins.at(step.origins.back());
  const auto whole = text + "\nmain";
  return whole.substr(origin.begin, origin.end - origin.begin) + ": " + step.failure;
}

std::string Text::refusal() const {
  const auto parsed = read(text, "deadlockfree");
  const auto result = verify::verify(parsed.program, parsed.provenance, {{0}});
  return result ? "" : result.error().message;
}

Text processText(const std::string& body) {
  return Text("type short is queue 2 of 0..3\nprocess P is\n" + body +
              "\ncomponent main is par * in P end");
}

} // namespace proskill::test
