#pragma once

#include "analysis/flow/flow.h"
#include "analysis/names/reuse.h"

#include <memory>
#include <vector>

namespace proskill::ide {

/// What may be true where in a program: computed of the program as it is, or as it was before edits
/// of white space and comments, which do not change what flows where. Never changes.
class KnownFlow {
public:
  /// Computes it. \pre the program has no errors
  explicit KnownFlow(std::shared_ptr<const analysis::Program> program);

  /// The same flow after such an edit; null after too many.
  [[nodiscard]] std::shared_ptr<const KnownFlow> after(analysis::FileId file,
                                                       const syntax::Replacement& edit) const;

  /// Its places are those of the program that it was computed of.
  [[nodiscard]] const analysis::flow::Flow& flow() const { return computed->flow; }
  [[nodiscard]] const analysis::flow::System& system() const { return computed->flow.system; }
  [[nodiscard]] const analysis::flow::Solver& solver() const { return computed->flow.solver; }
  /// Where a place of the program as it is now stood in that one.
  [[nodiscard]] analysis::Location then(analysis::Location now) const;
  /// Where a place of that program stands now.
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
  std::vector<Step> steps; ///< since then
};

} // namespace proskill::ide
