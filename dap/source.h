#pragma once

#include "dap/steps.h"

#include "analysis/program/program.h"
#include "codegen/model.h"
#include "verify/trace/simulation.h"

#include <memory>
#include <set>

namespace proskill::dap {

/// Where the steps of a session come from: a trace, or a simulation in which somebody chooses.
class StepSource {
public:
  virtual ~StepSource() = default;
  /// Name, words, verdict and first values; its steps are those of a recorded trace.
  [[nodiscard]] virtual const Trace& trace() const = 0;
  [[nodiscard]] virtual bool isSimulation() const = 0;
  /// After the steps that were taken: what may come next, the likeliest first.
  [[nodiscard]] virtual std::vector<Step> choices() const = 0;
  /// \pre choice < choices().size()
  virtual void take(std::size_t choice) = 0;
  /// \pre a step was taken
  virtual void undo() = 0;
  /// Whether a step can be at a line.
  [[nodiscard]] virtual bool hasLine(const std::filesystem::path& path, unsigned line) const = 0;
};

/// One choice at a time: the trace's next step.
[[nodiscard]] std::unique_ptr<StepSource> recorded(Trace trace);

/// \param program checked, without errors
[[nodiscard]] std::expected<std::unique_ptr<StepSource>, std::string>
simulated(analysis::Program program, const std::string& mainSkill);

} // namespace proskill::dap
