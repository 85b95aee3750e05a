#pragma once

#include "ide/verdicts/verification.h"
#include "verify/trace/simulation.h"

#include <map>
#include <memory>
#include <span>

namespace proskill::ide {

/// A step of a run as it is found again: in the same program, and in the program after edits.
struct ChosenStep {
  std::string actor;
  std::string description;
  /// Of the Fiacre model: tell apart steps that read the same. After edits others may have them.
  std::vector<std::string> transitions;
  verify::When when = verify::When::Early;
};

/// The first of the chosen steps that is not possible where it was.
struct MissingStep {
  std::size_t index = 0; ///< among those that were asked for
  std::string why;
};

/// A run of a program that somebody chooses the steps of, in the program's words.
class SimulatedRun {
public:
  /// What cannot be simulated is said in words.
  [[nodiscard]] static std::expected<SimulatedRun, std::string> start(codegen::Model model);

  [[nodiscard]] const std::string& mainSkill() const { return model->mainSkill; }
  [[nodiscard]] const codegen::Model& of() const { return *model; }
  /// The first values and the steps that were taken.
  [[nodiscard]] const Trace& trace() const { return taken; }
  /// What may come next, the likeliest first; empty where nothing is possible any more.
  [[nodiscard]] std::vector<TraceStep> choices() const;
  /// \pre choice < choices().size()
  void take(std::size_t choice, verify::When when = verify::When::Early);
  /// False at the start.
  bool undo();
  /// Makes these the steps of the run, from the first that differs on. Where one is not possible,
  /// the run ends before it.
  [[nodiscard]] std::optional<MissingStep> follow(std::span<const ChosenStep> wanted);
  /// Each variable's value now.
  [[nodiscard]] std::map<std::string, std::string> values() const;

private:
  SimulatedRun(std::unique_ptr<const codegen::Model> of, verify::Simulation started);
  [[nodiscard]] std::string whyMissing(const ChosenStep& wanted) const;
  /// A choice as the step that it would be.
  [[nodiscard]] TraceStep stepOf(const verify::Choice& choice) const;

  std::unique_ptr<const codegen::Model> model;
  verify::Simulation simulation;
  Trace taken;
  std::vector<verify::When> dated; ///< of each step that was taken
};

/// A value that a run was expected to end with.
struct UnmetValue {
  std::string variable;
  std::string expected;
  std::string actual; ///< empty: the program has no such variable
};

/// What of the expectation is not so now.
[[nodiscard]] std::vector<UnmetValue> unmet(const SimulatedRun& run,
                                            const std::map<std::string, std::string>& expected);

} // namespace proskill::ide
