#include "fiacre/check/check.h"
#include "tests/codegen/platform.h"
#include "tests/support/random/random_program.h"
#include "tests/support/texts.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace proskill;
using codegen::Edition;

namespace {

template <class Visit> void forEachTag(const fiacre::Statement& statement, Visit&& visit) {
  if (statement.kind == fiacre::StatementKind::Tag) visit(statement.name);
  for (const auto& child : statement.children) forEachTag(child, visit);
}

/// Every tag of a model, with a property that it is absent.
std::vector<std::string> askForTags(fiacre::Program& program) {
  std::vector<std::string> names;
  program.properties.clear();
  for (std::uint32_t place = 1; place <= program.processes.size(); ++place)
    for (const auto& from : program.processes[place - 1].transitions)
      forEachTag(from.statement, [&](const std::string& tag) {
        fiacre::Observable seen{.kind = fiacre::ObservableKind::Tag, .path = {place}, .name = tag};
        fiacre::Pattern absent{.kind = fiacre::PatternKind::Absent, .operands = {seen}};
        program.properties.push_back({"p" + std::to_string(names.size()), absent, 0, ""});
        names.push_back(tag);
      });
  return names;
}

/// The tags that some run passes; nullopt if the model is too large for a test.
std::optional<std::set<std::string>> reachedTags(fiacre::Program program) {
  const auto names = askForTags(program);
  std::vector<verify::Question> questions;
  for (std::size_t i = 0; i < names.size(); ++i) questions.push_back({i});
  verify::Options options;
  options.limits.classes = 20'000;
  const auto result = verify::verify(program, {}, questions, options);
  if (!result) FAIL(result.error().message);
  if (!result->exploration.complete) return std::nullopt;
  std::set<std::string> reached;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (result->answers[i].truth == verify::Truth::False) reached.insert(names[i]);
  return reached;
}

/// A return in the very tick of the lower bound may cause a warning.
bool isUndershoot(const std::string& tag) { return tag.ends_with("_undershoot"); }

std::string strange(const std::set<std::string>& runtime, const std::set<std::string>& offline) {
  std::string text;
  for (const auto& tag : runtime)
    if (!offline.contains(tag) && !isUndershoot(tag)) text += tag + " ";
  return text;
}

std::optional<codegen::Model> modelOf(const analysis::Program& program, Edition edition) {
  auto model = codegen::generate(program, {.edition = edition, .ticksPerSecond = 2});
  if (!model) return std::nullopt; // a bound between two ticks
  return std::move(*model);
}

} // namespace

TEST_CASE("what happens at runtime, on a platform that keeps its times, may happen offline") {
  test::ProgramSize size;
  size.properties = 0;
  size.environment = 0; // at run time anything may happen at any time
  size.library = 0;
  std::size_t compared = 0;
  std::size_t tags = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto text = test::textOf(test::randomProgram(seed, test::varied(seed, size)));
    const auto program = test::programOfText(text);
    const auto runtime = modelOf(program, Edition::Runtime);
    const auto offline = modelOf(program, Edition::Compact);
    if (!runtime || !offline) continue;
    const auto closed = test::withPlatform(*runtime, program);
    INFO("seed " << seed << "\n" << text);
    for (const auto& problem : fiacre::check(closed))
      FAIL(problem.place << ": " << problem.message);
    const auto may = reachedTags(offline->fiacre);
    const auto does = reachedTags(closed);
    if (!may || !does) continue;
    CHECK(strange(*does, *may) == "");
    ++compared;
    tags += does->size();
  }
  CHECK(compared > 150);
  CHECK(tags > 5 * compared);
}
