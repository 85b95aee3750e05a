#pragma once

#include "cache/spill_directory.h"
#include "cli/output/checkpoint.h"
#include "cli/output/tina_backend.h"
#include "cli/ranks/verify_ranks.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/paint.h"
#include "codegen/model.h"
#include "report/verify_report.h"
#include "verify/graph/state_graph.h"

#include <chrono>
#include <set>

namespace proskill::cli {

enum class VerifyFormat : std::uint8_t { Text, Json, JUnit, Sarif };

/// The arguments of `proskill verify`.
struct VerifyArguments {
  std::string file;
  std::string environment;
  std::vector<std::string> added;
  std::vector<std::string> properties;
  std::string mainSkill;
  VerifyFormat format = VerifyFormat::Text;
  report::ShowTraces traces = report::ShowTraces::Failed;
  ColourChoice colour = ColourChoice::Auto;
  std::optional<unsigned> jobs; ///< none: as many as pay on this machine
  std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();
  std::optional<double> timeLimit;
  std::optional<std::uint64_t> memoryLimit; // MiB
  std::optional<std::uint64_t> classLimit;
  std::string saveTraces;
  std::string report;
  std::vector<std::string> reduce;
  std::string cache;
  CheckpointArguments checkpoint;
  std::string spill; ///< a directory; empty: searches stay in memory
  std::string graph;
  verify::GraphKind graphOf = verify::GraphKind::Classes;
  BackendArguments backend;
  bool fairRuns = true;
  bool list = false; ///< print only the names of the properties
  bool strict = false;
  bool durations = false; ///< measure how long skills take
  bool explainSize = false;
  bool expanded = false;
  bool mpi = false;
  VerifyRanks* ranks = nullptr;                    ///< with `mpi`, once they are connected
  cache::SpillDirectory* spillDirectory = nullptr; ///< with `spill`, once it is open
  codegen::StateVariableAutomata automata = codegen::StateVariableAutomata::Exact;
};

/// Adds the command's options and their help. `arguments` must outlive the command.
void addVerifyOptions(CLI::App& command, VerifyArguments& arguments);

/// Why several ranks cannot do what is asked; nothing if they can.
[[nodiscard]] std::optional<std::string> problemWithRanks(const VerifyArguments& arguments);

/// Opens the directory for searches on disk. The error is a message, also if these cannot do what
/// is asked.
[[nodiscard]] std::expected<std::unique_ptr<cache::SpillDirectory>, std::string>
openSpill(const VerifyArguments& arguments);

/// The reductions with these names; all if there are none.
[[nodiscard]] std::set<verify::Reduction> chosenReductions(const std::vector<std::string>& names);

} // namespace proskill::cli
