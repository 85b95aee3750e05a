#include "tests/support/random/random_model.h"

#include "fiacre/print/print.h"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <string>

/// Writes random models as files: print_models KIND FIRST COUNT DIRECTORY

namespace proskill::test {

namespace {

void forgetTimes(fiacre::Statement& statement) {
  if (statement.kind == fiacre::StatementKind::Wait) statement.interval = {};
  for (auto& child : statement.children) forgetTimes(child);
}

/// Every step may wait, and none has to happen.
fiacre::Program untimed(fiacre::Program program) {
  for (auto& process : program.processes)
    for (auto& transition : process.transitions) forgetTimes(transition.statement);
  for (auto& component : program.components)
    for (auto& port : component.ports) port.interval.reset();
  return program;
}

using Make = std::function<fiacre::Program(std::uint64_t)>;

const std::map<std::string, Make> kKinds{
    {"plain", randomModel},
    {"data", randomModelWithData},
    {"observer", randomModelWithObserver},
    {"untimed", [](std::uint64_t seed) { return untimed(randomModel(seed)); }},
    {"untimed-data", [](std::uint64_t seed) { return untimed(randomModelWithData(seed)); }},
    {"untimed-observer", [](std::uint64_t seed) { return untimed(randomModelWithObserver(seed)); }},
};

int print(const std::string& kind, std::uint64_t first, std::uint64_t count,
          const std::filesystem::path& directory) {
  const auto make = kKinds.find(kind);
  if (make == kKinds.end()) return 2;
  for (auto seed = first; seed < first + count; ++seed) {
    std::ofstream file(directory / (kind + "-" + std::to_string(seed) + ".fcr"));
    file << fiacre::print(make->second(seed));
  }
  return 0;
}

} // namespace

} // namespace proskill::test

int main(int count, char** words) {
  if (count != 5) {
    std::cerr << "usage: print_models KIND FIRST COUNT DIRECTORY\n";
    return 2;
  }
  return proskill::test::print(words[1], std::stoull(words[2]), std::stoull(words[3]), words[4]);
}
