#pragma once

#include "tina/ktz_text.h"
#include "tina/names.h"
#include "verify/compile/compile.h"
#include "verify/trace/witness.h"

#include <memory>

namespace proskill::tina {

/// Maps runs from Tina to the model by following them step by step in the model's own transition
/// system. So a trace has dates and is replayed, like a trace of the engine.
class Guide {
public:
  /// \pre the arguments outlive this
  [[nodiscard]] static std::expected<std::unique_ptr<Guide>, verify::Unsupported>
  make(const fiacre::Program& program, const fiacre::Provenance& provenance,
       const std::vector<verify::Question>& questions);

  /// Whether the engine itself can decide that a run violates the property.
  [[nodiscard]] bool judges(std::size_t question) const {
    const auto kind = goals[question].kind;
    return kind == verify::GoalKind::Events || kind == verify::GoalKind::Condition ||
           kind == verify::GoalKind::Deadlock;
  }

  /// The trace with these transitions, up to the violation of the property; up to their end if the
  /// engine cannot decide the property. The error says why there is no trace.
  [[nodiscard]] std::expected<verify::Trace, std::string>
  follow(std::size_t question, const std::vector<std::string>& transitions) const;

  /// A shortest path in a graph to a violation of the property; nothing if there is none.
  /// \pre judges(question)
  [[nodiscard]] std::expected<std::optional<verify::Trace>, std::string>
  search(std::size_t question, const KtzGraph& graph) const;

private:
  Guide(verify::Compiled compiled, const fiacre::Provenance& provenance, const std::string& main);

  struct Node {
    std::vector<verify::Word> state;
    std::uint32_t parent = verify::kNone;
    verify::TransitionId transition = verify::kNone;
  };
  struct Taken {
    verify::TransitionId transition = verify::kNone;
    bool exact = false; ///< the number in the name matches too
    std::vector<verify::Word> state;
    verify::Bits events;
  };

  [[nodiscard]] std::vector<Taken> possible(const std::vector<verify::Word>& state,
                                            const std::vector<Names::Part>& parts) const;
  [[nodiscard]] bool maySee(const verify::Goal& goal, const std::vector<verify::Word>& before,
                            const std::vector<verify::Word>& after,
                            const verify::Bits& events) const;
  [[nodiscard]] bool seesAtOnce(const verify::Goal& goal,
                                const std::vector<verify::Word>& first) const;
  [[nodiscard]] std::expected<verify::Trace, std::string>
  follow(const verify::Goal& goal, const std::vector<std::vector<Names::Part>>& steps, bool toEnd,
         bool exactly) const;
  [[nodiscard]] bool agrees(const std::vector<verify::Word>& state, const KtzGraph& graph,
                            std::uint32_t node) const;
  [[nodiscard]] static verify::Steps wayTo(const std::vector<Node>& nodes, std::uint32_t node);

  std::vector<verify::Goal> goals;
  verify::Goal anything; ///< a goal that holds everywhere
  verify::System system;
  verify::Enabling enabling;
  Names names;
  verify::Reductions none;
  verify::Options noLimits; ///< traces of the tools' runs are short
  verify::LimitWatch unlimited;
  verify::Witness witness;
};

} // namespace proskill::tina
