#pragma once

#include "verify/graph/graph_recorder.h"
#include "verify/limits.h"
#include "verify/ranks.h"
#include "verify/space/state_tree.h"
#include "verify/state/enabled.h"
#include "verify/state/firing_domains.h"
#include "verify/threads/translation.h"

#include <span>

namespace proskill::verify {

/// The rank that has the classes of a marking.
[[nodiscard]] unsigned ownerOf(const Ranks& ranks, std::span<const Word> marking);

/// A transition that is possible in a marking.
struct MarkingStep {
  TransitionId transition = 0;
  std::uint32_t marking = kNone;    ///< the one that it leads to, if that has a number
  RootTable::ClaimId claim = kNone; ///< otherwise, if that is claimed
  std::size_t words = 0;            ///< otherwise, index of its first word
  std::uint32_t signature = 0;      ///< with the words: in the domains of the expander
  std::uint32_t label = 0;          ///< for the recorder
  bool isElsewhere = false;         ///< another rank has the marking
};

/// All that is possible in a marking, except for time.
struct ExpandedMarking {
  std::vector<MarkingStep> steps;
  std::vector<Word> words;             ///< markings that have neither number nor claim
  std::vector<std::uint32_t> possible; ///< the transitions, and where they lead if they branch
  Unsupported failure;                 ///< of the first transition that cannot be computed
};

/// Who claimed a marking, and its signature in the domains of that expander.
struct Claimant {
  std::uint32_t member = 0;
  std::uint32_t signature = 0;
};

/// Computes what is possible in markings. Several may work at once, while nothing is added to the
/// markings but claims.
class MarkingExpander {
public:
  /// \pre the arguments outlive this
  /// \param self number of this expander among those that work at once
  /// \param to gives names to steps; null: they are not needed
  /// \param shared the ranks that count together; null: there are no others
  MarkingExpander(const System& of, const Enabling& how, StateTree& all, const LimitWatch& watch,
                  std::uint32_t self, GraphRecorder* to, const Ranks* shared);

  /// Call this after each RootTable::prepareClaims(). \param room by claim
  void startChunk(std::vector<Claimant>& room);
  /// The result is complete after the next call, or after finish(): meanwhile the processor loads
  /// what is needed for it.
  /// \throw LimitMet
  void expand(std::uint32_t marking, ExpandedMarking& to);
  void finish();
  /// The number of a signature of this expander in the domains of the graph.
  [[nodiscard]] std::uint32_t translate(std::uint32_t signature, FiringDomains& to) {
    return shared.get(signature, [&] { return to.adopt(domains, signature); });
  }

private:
  /// A marking whose steps are known, but not what they lead to.
  struct Begun {
    ExpandedMarking* made = nullptr;
    TransitionSet enabled;
    std::vector<Word> targets; ///< the markings after the steps
    StateTree::Group group;
  };

  void fireAll();
  [[nodiscard]] bool fireFromState(TransitionId transition);
  void noteFailure(TransitionId transition);
  void notePossible(TransitionId transition, const Word* after);
  void findTargets(Begun& from);
  [[nodiscard]] bool isFound(MarkingStep& step, const std::optional<SoughtRoot>& root,
                             std::span<const Word> after, const TransitionSet& before);
  [[nodiscard]] std::uint32_t signatureAfter(const MarkingStep& step, std::span<const Word> after,
                                             const TransitionSet& before);

  const System& system;
  const Enabling& enabling;
  StateTree& markings;
  LimitWatch limits;
  std::uint32_t number;
  GraphRecorder* recorder;
  const Ranks* ranks;
  FiringDomains domains;       ///< only its signatures are used
  Translation shared;          ///< signatures in the domains of the graph
  std::vector<bool> branching; ///< by transition: whether its parts may end in several locations

  RootTable::Allotment own;
  std::vector<Claimant>* claimants = nullptr; ///< by claim
  Begun current;
  Begun previous;       ///< if it made something
  StateTree::Path path; ///< the nodes of the current marking
  std::vector<Word> state;
  std::vector<Word> next;
  TransitionSet nextEnabled;
  StepLog log;
};

/// The number of what is in a marking and affects time.
[[nodiscard]] std::uint32_t signatureOf(const TransitionSet& allowed, const System& system,
                                        const Enabling& enabling, FiringDomains& domains);

} // namespace proskill::verify
