#pragma once

#include "analysis/program/program.h"
#include "ide/verdicts/simulated_run.h"
#include "report/ordered_json.h"

/// Runs whose steps somebody chooses, as the panel asks for them and as they are saved for tests.
/// A saved run is a trace (docs/verify.schema.json) with some more members: docs/view.md.
namespace proskill::report {

/// The steps of a run, and what it is expected to end with.
struct ChosenRun {
  std::string name;
  std::string mainSkill; ///< empty: as the program says
  std::vector<ide::ChosenStep> steps;
  std::map<std::string, std::string> expected; ///< values of variables after the last step
};

/// Reads a saved run, or as much of one as a request has; any trace is a run that expects nothing.
/// The error is a sentence.
[[nodiscard]] std::expected<ChosenRun, std::string> readChosenRun(const OrderedJson& json);

/// Where a run is: its `trace`, the `choices` that it has next, the `missing` step of those that
/// were asked for, and the values that are `unmet`, which is empty while a step is missing.
[[nodiscard]] OrderedJson simulationJson(const analysis::Program& program,
                                         const ide::SimulatedRun& run, const ChosenRun& asked,
                                         const std::optional<ide::MissingStep>& missing);

} // namespace proskill::report
