#include "fuzz/targets.h"
#include "tina/ktz_text.h"
#include "tina/names.h"
#include "tina/outputs.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace proskill::fuzz {

namespace {

using namespace tina;

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string text;
  for (const auto& part : parts) text.append(text.empty() ? "" : between).append(part);
  return text;
}

void formulasAreRead(std::string_view text) {
  const auto file = readLtl(text);
  for (const auto& query : file.queries)
    expect(!query.empty() && query.find_first_of(";#") == std::string::npos,
           "a formula is one statement");
  const auto again = readLtl(file.definitions + joined(file.queries, ";\n"));
  expect(again.definitions == file.definitions && again.queries == file.queries,
         "formulas are read as they were written");
}

void verdictsAreRead(const std::string& text) {
  for (std::size_t count = 0; count < 4; ++count) {
    const auto verdicts = readVerdicts(text, count);
    if (!verdicts) continue;
    expect(verdicts->size() == count, "there are as many verdicts as formulas");
    const auto more = readVerdicts(text + "\nquery FALSE\n", count + 1);
    expect(more && !more->back(), "a further verdict is read");
  }
  if (const auto counts = readCounts(text))
    expect(counts->complete, "counts are of a whole exploration");
  expect(saysUnfinished(text + "\naborted\n"), "an exploration that stopped is noticed");
}

void pathsAreRead(const std::string& text) {
  if (const auto names = readScenario(text)) {
    expect(!names->empty(), "a scenario has transitions");
    expect(readScenario(joined(*names, " ")) == names, "a scenario is read as it was written");
  }
  for (const auto& name : readCounterexample(text))
    expect(!name.empty() && name.find_first_of(" \t\r\n") == std::string::npos,
           "a transition is one word");
}

std::expected<KtzGraph, std::string> ktzOf(const std::string& text) {
  std::istringstream in(text);
  return readKtzText(in);
}

/// One name per line: an open brace extends it to the closing one.
std::string written(const KtzGraph& graph) {
  std::ostringstream text;
  for (std::size_t i = 0; i < graph.states.size(); ++i) {
    text << "state " << i << "\n";
    for (const auto& [property, value] : graph.states[i].has)
      text << "props S." << graph.properties.at(property) << "*" << value << "\n";
    for (const auto& [label, target] : graph.states[i].edges)
      text << "trans E." << graph.labels.at(label) << "/" << target << "\n";
  }
  return text.str();
}

void graphIsRead(const std::string& text) {
  const auto graph = ktzOf(text);
  if (!graph) return;
  expect(!graph->states.empty(), "a graph has a state");
  for (const auto& state : graph->states)
    for (const auto& [label, target] : state.edges)
      expect(label < graph->labels.size() && target < graph->states.size(),
             "an edge leads to a state of the graph");
  const auto again = ktzOf(written(*graph));
  expect(again && again->properties == graph->properties && again->labels == graph->labels &&
             written(*again) == written(*graph),
         "a graph is read as it was written");
}

/// Two processes, one of which frac renames; a variable of each, and one of the main component.
verify::System aSystem() {
  verify::System system;
  system.cells = {{.name = "speed"}, {.name = "location"}, {.name = "play_1.x"}, {.name = "rung"}};
  system.instances = {{.name = "play_1", .locations = {"idle", "go_on"}, .location = 1},
                      {.name = "skill_takeoff_1", .locations = {"s"}, .location = 3}};
  return system;
}

void namesAreOfTheModel(const std::string& text) {
  static const verify::System system = aSystem();
  static const Names names(system, "main");
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (const auto parts = names.transition(word)) {
      expect(!parts->empty() && std::ranges::is_sorted(*parts), "a transition has parts, in order");
      expect(names.partsWithin(word) == *parts, "all parts of a transition are the model's");
    }
    for (const auto& part : names.partsWithin(word))
      expect(part.instance < system.instances.size(), "a part is of an instance");
    if (const auto place = names.place(word))
      expect(place->location < system.instances.at(place->instance).locations.size(),
             "a place is a location of an instance");
    if (const auto variable = names.variable(word))
      expect(*variable < system.cells.size(), "a variable is one of the model");
  }
}

} // namespace

void tina(std::string_view bytes) {
  const std::string text(bytes);
  formulasAreRead(text);
  verdictsAreRead(text);
  pathsAreRead(text);
  graphIsRead(text);
  namesAreOfTheModel(text);
}

} // namespace proskill::fuzz
