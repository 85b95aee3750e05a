#pragma once

#include "ide/verdicts/verification.h"
#include "verify/trace/simulation.h"

#include <map>
#include <memory>
#include <span>

namespace proskill::ide {

/// A chosen step, which can be found again in the same program and in edited versions.
struct ChosenStep {
  std::string actor;
  std::string description;
  /// Transitions of the Fiacre model; they distinguish steps with the same description. Their names
  /// may change with edits.
  std::vector<std::string> transitions;
  verify::When when = verify::When::Early;
};

/// The first of the chosen steps that was not possible.
struct MissingStep {
  std::size_t index = 0; ///< index in the list of chosen steps
  std::string why;
};

/// A run of a program whose steps the user chooses, in the program's terms.
class SimulatedRun {
public:
  /// The error explains to the user why the model cannot be simulated.
  [[nodiscard]] static std::expected<SimulatedRun, std::string> start(codegen::Model model);

  [[nodiscard]] const std::string& mainSkill() const { return model->mainSkill; }
  [[nodiscard]] const codegen::Model& of() const { return *model; }
  /// The initial values and the steps taken so far.
  [[nodiscard]] const Trace& trace() const { return taken; }
  /// The possible next steps, the likeliest first; empty if no step is possible.
  [[nodiscard]] std::vector<TraceStep> choices() const;
  /// \pre choice < choices().size()
  void take(std::size_t choice, verify::When when = verify::When::Early);
  /// Returns false at the start.
  bool undo();
  /// Makes these the steps of the run, keeping the steps before the first difference. If a step is
  /// not possible, the run ends before it.
  [[nodiscard]] std::optional<MissingStep> follow(std::span<const ChosenStep> wanted);
  /// The current value of each variable.
  [[nodiscard]] std::map<std::string, std::string> values() const;

private:
  SimulatedRun(std::unique_ptr<const codegen::Model> of, verify::Simulation started);
  [[nodiscard]] std::string whyMissing(const ChosenStep& wanted) const;
  /// The step that a choice would be.
  [[nodiscard]] TraceStep stepOf(const verify::Choice& choice) const;

  std::unique_ptr<const codegen::Model> model;
  verify::Simulation simulation;
  Trace taken;
  std::vector<verify::When> dated; ///< by step taken
};

/// A value that differs from the expected one at the end of a run.
struct UnmetValue {
  std::string variable;
  std::string expected;
  std::string actual; ///< empty: the program has no such variable
};

/// The expectations that do not hold now.
[[nodiscard]] std::vector<UnmetValue> unmet(const SimulatedRun& run,
                                            const std::map<std::string, std::string>& expected);

} // namespace proskill::ide
