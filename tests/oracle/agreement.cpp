#include "tests/oracle/agreement.h"

#include "tests/oracle/replay.h"
#include "tests/support/oracle/judge.h"
#include "tests/support/spill_in_memory.h"

#include "fiacre/print/print.h"

#include <set>

namespace proskill::oracle {

using fiacre::Observable;
using fiacre::ObservableKind;
using fiacre::PatternKind;
using fiacre::Statement;
using verify::Options;
using verify::Reduction;
using verify::Truth;

namespace {

std::string wordOf(Truth truth) {
  return truth == Truth::True ? "true" : truth == Truth::False ? "false" : "unknown";
}

std::string describe(const fiacre::Program& program, std::size_t property,
                     const std::string& engine, const std::string& oracle) {
  const auto& asked = program.properties[property];
  return asked.name + ": " + fiacre::printPattern(asked.pattern, program.main) +
         "\n  engine: " + engine + "\n  oracle: " + oracle;
}

void collectTags(const Statement& statement, std::set<std::string>& tags) {
  if (statement.kind == fiacre::StatementKind::Tag) tags.insert(statement.name);
  for (const auto& child : statement.children) collectTags(child, tags);
}

void askForAbsence(fiacre::Program& program, Observable observable) {
  fiacre::Property property{.name = "control" + std::to_string(program.properties.size())};
  property.pattern = {.kind = PatternKind::Absent, .operands = {std::move(observable)}};
  program.properties.push_back(std::move(property));
}

} // namespace

const std::vector<std::pair<std::string, Options>>& settings() {
  static const std::vector<std::pair<std::string, Options>> all = [] {
    std::vector<std::pair<std::string, Options>> made;
    made.emplace_back("all reductions", Options{});
    made.emplace_back("no reduction", Options{.reductions = {}});
    const std::vector<std::pair<std::string, Reduction>> names{
        {"dead variables", Reduction::DeadVariables}, {"live variables", Reduction::LiveVariables},
        {"open variables", Reduction::FreeInputs},    {"private moves", Reduction::PrivateMoves},
        {"safe steps", Reduction::StubbornSets},      {"slices", Reduction::Slices},
        {"refinement", Reduction::Refinement},        {"inclusion", Reduction::Inclusion},
        {"extrapolation", Reduction::Extrapolation}};
    for (const auto& [name, reduction] : names) {
      made.emplace_back("without " + name, Options{});
      made.back().second.reductions.erase(reduction);
      made.emplace_back("only " + name, Options{.reductions = {reduction}});
      if (reduction == Reduction::PrivateMoves) // they are on open variables
        made.back().second.reductions.insert(Reduction::FreeInputs);
      if (reduction == Reduction::Slices || reduction == Reduction::Refinement)
        made.back().second.classesBeforeSlices = 0;
    }
    made.emplace_back("slices first", Options{.classesBeforeSlices = 0});
    made.emplace_back("slices in the middle", Options{.classesBeforeSlices = 5});
    made.emplace_back("two threads",
                      Options{.jobs = 2, .classesBeforeThreads = 0, .nodesBeforeThreads = 0});
    static test::SpillInMemory disk;
    made.emplace_back("on disk", Options{.spill = &disk, .spillBytes = 1});
    made.emplace_back("on disk, no reduction",
                      Options{.reductions = {}, .spill = &disk, .spillBytes = 5000});
    made.emplace_back(
        "three threads, no reduction",
        Options{.reductions = {}, .jobs = 3, .classesBeforeThreads = 5, .nodesBeforeThreads = 0});
    return made;
  }();
  return all;
}

Judged judge(const fiacre::Program& program, std::size_t limit, Reading reading) {
  auto plain = std::make_shared<const Interpreter>(program);
  const auto model =
      reading == Reading::Engine ? plain : std::make_shared<const Interpreter>(program, reading);
  RegionGraph graph(*model, limit);
  Judged judged{{}, graph.nodes().size(), graph.complete(), std::move(plain)};
  if (judged.complete)
    for (const auto& property : program.properties)
      judged.truths.push_back(isTrue(*model, graph, property.pattern));
  return judged;
}

std::optional<std::string> disagreement(const fiacre::Program& program,
                                        const fiacre::Provenance& provenance, const Judged& judged,
                                        const std::pair<std::string, Options>& setting,
                                        std::size_t* decided, std::uint64_t* sliced) {
  std::vector<verify::Question> questions; // those that the oracle has decided
  for (std::size_t i = 0; i < program.properties.size(); ++i)
    if (judged.truths[i]) questions.push_back({i});
  Options options = setting.second;
  // Without extrapolation a model may have infinitely many zones; what was decided before the limit
  // must still be correct. With it every question is decided.
  const bool mayStayOpen = !options.reductions.contains(Reduction::Extrapolation);
  options.limits.classes = 200'000;
  auto result = verify::verify(program, provenance, questions, options);
  if (!result) return "the engine cannot run it: " + result.error().message;
  if (sliced) *sliced = result->exploration.sliced;
  for (std::size_t each = 0; each < questions.size(); ++each) {
    const auto& answer = result->answers[each];
    const std::size_t i = questions[each].property;
    std::string expected = *judged.truths[i] ? "true" : "false";
    bool open = mayStayOpen && answer.truth == Truth::Unknown && !result->exploration.complete;
    if (decided && answer.truth != Truth::Unknown) ++*decided;
    if (!open && wordOf(answer.truth) != expected)
      return describe(program, i, wordOf(answer.truth) + " " + answer.reason, expected) +
             "\n  with " + setting.first;
    if (!answer.trace) continue;
    if (auto wrong =
            replay(*judged.model, provenance, program.properties[i].pattern, *answer.trace))
      return describe(program, i, wordOf(answer.truth), "the trace cannot be replayed, " + *wrong) +
             "\n  with " + setting.first;
  }
  return std::nullopt;
}

fiacre::Program askedForControl(fiacre::Program program) {
  Interpreter model(program);
  std::vector<Observable> wanted;
  for (const auto& instance : model.instances()) {
    for (const auto& state : instance.process->states)
      wanted.push_back({.kind = ObservableKind::State, .path = instance.path, .name = state.name});
    std::set<std::string> tags;
    for (const auto& from : instance.process->transitions) collectTags(from.statement, tags);
    for (const auto& tag : tags)
      wanted.push_back({.kind = ObservableKind::Tag, .path = instance.path, .name = tag});
  }
  fiacre::Program asked = program;
  for (auto& observable : wanted) askForAbsence(asked, std::move(observable));
  return asked;
}

} // namespace proskill::oracle
