#pragma once

#include "verify/checkpoint/checkpoint.h"
#include "verify/graph/domain_images.h"
#include "verify/graph/graph_recorder.h"
#include "verify/graph/number_sets.h"
#include "verify/ranks/distinct_count.h"
#include "verify/space/column.h"
#include "verify/space/state_tree.h"
#include "verify/state/enabled.h"
#include "verify/state/firing_domains.h"

#include <deque>
#include <variant>

namespace proskill::verify {

/// Builds the graph of state classes. The domains of a marking are a set, and sets are fired as a
/// whole: markings have few different ones. Domains that are found after their marking was expanded
/// wait until it is expanded again.
///
/// Several ranks count a graph together: each has the classes of the markings whose hashes name it,
/// and sends the others their classes.
class ClassGraph {
public:
  /// \param to records edges; null: they are only counted
  /// \param kept keeps the state of the exploration; null, or there is no recorder
  /// \param shared the ranks that count together; null, or there is neither of these
  ClassGraph(const System& of, LimitWatch& watch, GraphRecorder* to = nullptr,
             Checkpoint* kept = nullptr, Ranks* shared = nullptr);
  ClassGraph(const ClassGraph&) = delete;
  ClassGraph& operator=(const ClassGraph&) = delete;

  /// The counts, those of all ranks together. \throw LimitMet
  std::expected<Exploration, Unsupported> run();
  /// \pre it has finished, with a recorder
  [[nodiscard]] StateGraph recorded() const { return recorder->graph(initial, markings); }

private:
  /// A transition that is possible in the marking that is expanded.
  struct Successor {
    TransitionId transition = 0;
    std::uint32_t marking = kNone; ///< once it is known
    std::uint32_t label = 0;       ///< for the recorder
  };

  void start();
  void explore();
  void expand(std::uint32_t id);
  void fireAll();
  [[nodiscard]] bool fireFromState(TransitionId transition);
  void noteFailure(TransitionId transition);
  void notePossible(TransitionId transition, const Word* after);
  void findTargets();
  void enterTargets(std::uint32_t source);
  void recordEdges(std::uint32_t source, const Successor& step);
  void noteDomains(std::uint32_t possibleSet, SetId set);
  std::uint32_t numberOfPossible();
  std::uint32_t addDomain(std::uint64_t key);
  [[nodiscard]] std::uint32_t signatureOf(const TransitionSet& allowed);
  void describe(const TransitionSet& allowed);
  void enter(std::uint32_t marking, SetId more);
  void removeUnusedSets();
  [[nodiscard]] std::uint64_t bytes() const;
  [[nodiscard]] std::uint64_t growth() const;
  [[nodiscard]] Progress progress() const;

  // checkpoints
  void save();
  void write(CheckpointWriter& to) const;
  void writeClasses(CheckpointWriter& to, std::uint32_t marking) const;
  void resume(CheckpointReader& from);
  bool readMarking(CheckpointReader& from);
  [[nodiscard]] SetId readClasses(CheckpointReader& from, std::uint64_t count);
  void readDomains(CheckpointReader& from);

  // ranks
  [[nodiscard]] bool isElsewhere(const std::vector<Word>& marking) const;
  [[nodiscard]] unsigned ownerOf(const std::vector<Word>& marking) const;
  void sendSuccessors(TransitionId transition);
  void receive(CheckpointReader& records);
  void receiveRecord(CheckpointReader& records);
  [[nodiscard]] bool isRoundLeft();
  void shareEnd();
  void addUp();
  [[nodiscard]] std::uint64_t domainsOfAll(DistinctCount& distinct) const;

  const System& system;
  LimitWatch& limits;
  GraphRecorder* recorder;
  Checkpoint* checkpoint;
  Ranks* ranks;
  Enabling enabling;
  FiringDomains domains;
  NumberSets sets;
  DomainImages images;
  std::vector<bool> branching; ///< by transition: whether its parts may end in several locations
  StateTree markings;
  Column signatures; ///< by marking, as the next two
  Column classes;    ///< sets of domains
  Column expanded;   ///< those of them that are expanded
  std::deque<std::uint32_t> waiting;
  std::vector<std::vector<std::uint32_t>> possibleSets;
  NumberTable possibleTable;
  std::vector<std::uint64_t> domainKeys; ///< domains, with the transitions for which they hold
  NumberTable domainTable;
  RecentResults<std::monostate> noted; ///< sets of domains whose keys are known
  Exploration result;
  Unsupported failure;
  GraphRecorder::Class initial;

  SetId pending = NumberSets::kEmpty; ///< the domains of the marking that is expanded
  std::uint32_t signature = 0;        ///< that of this marking
  StateTree::Path path;               ///< its nodes
  std::vector<Word> state;
  TransitionSet enabled;
  std::vector<std::uint32_t> possible; ///< its transitions, and where they lead if they branch
  std::vector<Successor> successors;
  std::vector<Word> successorStates;
  std::vector<Word> next;
  TransitionSet nextEnabled;
  StepLog log;

  std::optional<Exchange> exchange;
  std::vector<std::vector<Word>> lastSent; ///< by rank: the last marking of the message being made
  std::vector<Word> received;
  TransitionSet receivedEnabled;
};

} // namespace proskill::verify
