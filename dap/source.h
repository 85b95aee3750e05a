#pragma once

#include "dap/steps.h"

#include "analysis/program/program.h"
#include "codegen/model.h"
#include "verify/trace/simulation.h"

#include <memory>
#include <set>

namespace proskill::dap {

/// The source of a session's steps: a trace, or a simulation with choices.
class StepSource {
public:
  virtual ~StepSource() = default;
  /// The trace's name, description, verdict and initial values; its steps if it is recorded.
  [[nodiscard]] virtual const Trace& trace() const = 0;
  [[nodiscard]] virtual bool isSimulation() const = 0;
  /// The possible next steps, the likeliest first.
  [[nodiscard]] virtual std::vector<Step> choices() const = 0;
  /// \pre choice < choices().size()
  virtual void take(std::size_t choice) = 0;
  /// \pre at least one step was taken
  virtual void undo() = 0;
  /// Whether some step has this line.
  [[nodiscard]] virtual bool hasLine(const std::filesystem::path& path, unsigned line) const = 0;
};

/// A recorded trace: the only choice is its next step.
[[nodiscard]] std::unique_ptr<StepSource> recorded(Trace trace);

/// \param program checked, without errors
[[nodiscard]] std::expected<std::unique_ptr<StepSource>, std::string>
simulated(analysis::Program program, const std::string& mainSkill);

} // namespace proskill::dap
