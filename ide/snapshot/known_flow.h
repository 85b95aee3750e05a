#pragma once

#include "analysis/flow/flow.h"
#include "analysis/names/reuse.h"

#include <memory>
#include <vector>

namespace proskill::ide {

/// The flow of a program, computed for its current text, or for an earlier text that differs only
/// in white space and comments. Immutable.
class KnownFlow {
public:
  /// Computes the flow. \pre the program has no errors
  explicit KnownFlow(std::shared_ptr<const analysis::Program> program);

  /// The same flow after such an edit; null after too many edits.
  [[nodiscard]] std::shared_ptr<const KnownFlow> after(analysis::FileId file,
                                                       const syntax::Replacement& edit) const;

  /// Its locations refer to the program for which it was computed.
  [[nodiscard]] const analysis::flow::Flow& flow() const { return computed->flow; }
  [[nodiscard]] const analysis::flow::System& system() const { return computed->flow.system; }
  [[nodiscard]] const analysis::flow::Solver& solver() const { return computed->flow.solver; }
  /// Converts a current location to that program.
  [[nodiscard]] analysis::Location then(analysis::Location now) const;
  /// Converts a location of that program to the current one.
  [[nodiscard]] analysis::Location now(analysis::Location then) const;

private:
  struct Computed {
    explicit Computed(std::shared_ptr<const analysis::Program> program)
        : program(std::move(program)), flow(*this->program) {}

    std::shared_ptr<const analysis::Program> program;
    analysis::flow::Flow flow;
  };
  struct Step {
    analysis::FileId file;
    syntax::Replacement edit;
  };

  std::shared_ptr<const Computed> computed;
  std::vector<Step> steps; ///< edits since then
};

} // namespace proskill::ide
