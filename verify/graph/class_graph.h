#pragma once

#include "verify/checkpoint/checkpoint.h"
#include "verify/graph/domain_images.h"
#include "verify/graph/marking_expander.h"
#include "verify/graph/number_lists.h"
#include "verify/graph/number_sets.h"
#include "verify/ranks/distinct_count.h"
#include "verify/space/column.h"
#include "verify/space/state_tree.h"
#include "verify/threads/team.h"
#include "verify/threads/thread_gain.h"

#include <atomic>
#include <deque>
#include <variant>

namespace proskill::verify {

/// Builds the graph of state classes. The domains of a marking are a set, and sets are fired as a
/// whole: markings have few different ones. Domains that are found after their marking was expanded
/// wait until it is expanded again.
///
/// Markings are expanded in chunks, if there are many by several threads. Meanwhile the first
/// thread fires the domains of the chunk before. The order of the markings does not depend on
/// either.
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
  /// Markings that are expanded together.
  struct Chunk {
    std::vector<std::uint32_t> markings;
    std::vector<ExpandedMarking> expanded; ///< by marking of the chunk
    std::vector<std::uint32_t> makers;     ///< by marking of the chunk: number of the expander
    std::size_t entered = 0;               ///< markings whose domains are fired
  };

  void start();
  void explore();
  void workTogether();
  void takeChunk();
  void prepareClaims();
  void work(std::size_t member);
  void expandFresh(std::size_t member);
  void settleFresh();
  [[nodiscard]] std::uint32_t numberOf(const MarkingStep& step, std::size_t at);
  void putBack();
  [[nodiscard]] std::vector<std::uint32_t> allWaiting() const;

  void enterReady();
  void enterNext();
  void prefetchNext() const;
  void fireDomains(std::uint32_t source, const MarkingStep& step);
  void recordEdges(std::uint32_t source, const MarkingStep& step);
  void noteDomains(std::uint32_t possibleSet, SetId set);
  std::uint32_t addDomain(std::uint64_t key);
  void describe(const TransitionSet& allowed);
  void describe(std::uint32_t signature);
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
  void send(const MarkingStep& step);
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
  StateTree markings;
  Column signatures; ///< by marking, as the next two
  Column classes;    ///< sets of domains
  Column expanded;   ///< those of them that are expanded
  std::deque<std::uint32_t> waiting;
  NumberLists possibleSets;              ///< see ExpandedMarking
  LargeVector<std::uint64_t> domainKeys; ///< domains, with the transitions for which they hold
  NumberTable domainTable;
  RecentResults<std::monostate> noted; ///< sets of domains whose keys are known
  Exploration result;
  Unsupported failure;
  GraphRecorder::Class initial;

  std::vector<std::unique_ptr<MarkingExpander>> expanders; ///< the first is of the calling thread
  std::optional<Team> team;                                ///< once there is much to do
  ThreadGain gain;
  unsigned jobs = 1;                  ///< threads for the chunk
  Chunk fresh;                        ///< that is being expanded
  Chunk ready;                        ///< expanded, with numbers of the markings after its steps
  std::atomic<std::size_t> next{0};   ///< the first marking of `fresh` that nobody works at
  std::vector<Claimant> claimants;    ///< by claim
  std::size_t stepsOfMarking = 1;     ///< about, of the last chunk
  std::uint64_t entries = 0;          ///< markings whose domains were fired
  SetId pending = NumberSets::kEmpty; ///< the domains of the marking that is fired from
  std::uint32_t signature = 0;        ///< that of this marking

  std::optional<Exchange> exchange;
  std::vector<std::vector<Word>> lastSent; ///< by rank: the last marking of the message being made
  std::vector<Word> state;
  TransitionSet enabled;
};

} // namespace proskill::verify
