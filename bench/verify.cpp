// Measures the verifier: states, memory, and the effect of reductions.

#include "bench/measure.h"
#include "bench/programs.h"
#include "tests/support/oracle/region_graph.h"
#include "tests/support/texts.h"

#include "codegen/model.h"
#include "verify/verify.h"

#include <fmt/format.h>

#include <cstdlib>

using namespace proskill;
using namespace proskill::bench;

namespace {

constexpr double kLongest = 10; ///< time limit of an exploration, in seconds

codegen::Model modelOf(const std::string& text) {
  auto model = codegen::generate(test::programOfText(text));
  if (model) return *std::move(model);
  fmt::print(stderr, "bench: {}\n", model.error().message);
  std::exit(1);
}

verify::Exploration explore(const codegen::Model& model, verify::Options options) {
  std::vector<verify::Question> questions;
  for (const auto& check : model.checks) questions.push_back({check.property});
  options.limits.seconds = kLongest;
  auto result = verify::verify(model.fiacre, model.provenance, questions, options);
  if (result) return result->exploration;
  fmt::print(stderr, "bench: {}\n", result.error().message);
  std::exit(1);
}

std::string shortly(const verify::Exploration& found) {
  return fmt::format("{} classes in {}{}", found.classes, duration(found.seconds),
                     found.complete ? "" : " (" + found.stopped + ")");
}

void addExploration(const Table& table, const std::string& what, const verify::Exploration& found,
                    const std::string& baseline, double ratio) {
  auto classes = static_cast<double>(found.classes);
  table.add({what, shortly(found), baseline, ratio});
  table.add({"  rate", rate(classes / found.seconds, "classes"), "", 0});
  table.add(
      {"  memory",
       fmt::format("{:.1f} B/class", static_cast<double>(found.bytes) / std::max(1.0, classes)), "",
       0});
}

void measure(const std::string& name, const std::string& text) {
  codegen::Model model = modelOf(text);
  Table table(fmt::format("{}: {} checks", name, model.checks.size()));
  verify::Exploration reduced = explore(model, {});
  verify::Exploration plain = explore(model, {.reductions = {}});
  addExploration(table, "all reductions", reduced, "none: " + shortly(plain),
                 reduced.seconds / plain.seconds);
  addExploration(table, "no reduction", plain, "", 0);
  verify::Options limited;
  limited.limits.seconds = kLongest;
  if (auto counted = verify::countClasses(model.fiacre, limited))
    addExploration(table, "the graph of state classes", *counted, "", 0);
}

/// The tests' interpreter, which evaluates the tree at each step, on the same model.
void measureAgainstInterpreter(const std::string& name, const std::string& text) {
  codegen::Model model = modelOf(text);
  oracle::Interpreter interpreter(model.fiacre);
  std::size_t states = 0;
  double naive =
      medianSeconds([&] { states = oracle::RegionGraph(interpreter, 100'000).discreteCount(); }, 1);
  verify::Exploration plain = explore(model, {.reductions = {}});
  double rateOfEngine = static_cast<double>(plain.markings) / plain.seconds;
  double rateOfInterpreter = static_cast<double>(states) / naive;
  Table table(name + ": the engine against an interpreter of the tree");
  table.add({"discrete states, no reduction", rate(rateOfEngine, "states"),
             "interpreter " + rate(rateOfInterpreter, "states"), rateOfEngine / rateOfInterpreter});
}

} // namespace

int main() {
  measure("drone", drone());
  for (auto [branches, skills] :
       {std::pair<std::size_t, std::size_t>{2, 4}, {3, 3}, {4, 2}, {4, 4}})
    measure(fmt::format("{} branches of {} skills", branches, skills),
            parallelFamily(branches, skills));
  measureAgainstInterpreter("2 branches of 2 skills", parallelFamily(2, 2));
}
