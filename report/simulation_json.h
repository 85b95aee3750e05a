#pragma once

#include "analysis/program/program.h"
#include "ide/verdicts/simulated_run.h"
#include "report/ordered_json.h"

/// Runs whose steps the user chooses, as requested by the panel and as saved for tests. A saved run
/// is a trace (docs/verify.schema.json) with additional members: docs/view.md.
namespace proskill::report {

/// The steps of a run and the expected values at its end.
struct ChosenRun {
  std::string name;
  std::string mainSkill; ///< empty: the program's default
  std::vector<ide::ChosenStep> steps;
  std::map<std::string, std::string> expected; ///< values of variables after the last step
};

/// Reads a saved run, or the part of one that a request contains. A trace is a run without
/// expectations. The error is a message.
[[nodiscard]] std::expected<ChosenRun, std::string> readChosenRun(const OrderedJson& json);

/// The state of a run: its `trace`, the next `choices`, the `missing` step that was not possible,
/// and the `unmet` values; `unmet` is empty while a step is missing.
[[nodiscard]] OrderedJson simulationJson(const analysis::Program& program,
                                         const ide::SimulatedRun& run, const ChosenRun& asked,
                                         const std::optional<ide::MissingStep>& missing);

} // namespace proskill::report
