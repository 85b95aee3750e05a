#pragma once

#include "verify/checkpoint/checkpoint.h"
#include "verify/graph/graph_recorder.h"
#include "verify/graph/number_lists.h"
#include "verify/ranks/distinct_count.h"
#include "verify/space/state_tree.h"
#include "verify/state/enabled.h"
#include "verify/state/firing_domains.h"

#include <deque>

namespace proskill::verify {

/// Builds the graph of state classes. All pending classes of a marking are expanded together, to
/// compute what does not depend on time only once.
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
  struct Marking {
    std::uint32_t signature = 0;
    std::uint32_t done = 0; ///< number of expanded classes
    bool waits = false;
  };

  void start();
  void explore();
  void expand(std::uint32_t id);
  void countDomains();
  std::uint32_t numberOfPossible();
  std::uint32_t addDomain(std::uint64_t key);
  void follow(std::uint32_t source, TransitionId transition);
  [[nodiscard]] bool fireFromState(TransitionId transition);
  [[nodiscard]] std::uint32_t signatureOf(const TransitionSet& allowed);
  std::uint32_t add(const std::vector<Word>& marking, const TransitionSet& allowed);
  void describe(const TransitionSet& allowed);
  void enter(std::uint32_t marking, ZoneId domain);
  [[nodiscard]] std::uint64_t bytes() const;
  [[nodiscard]] Progress progress() const;

  // checkpoints
  void save();
  void write(CheckpointWriter& to) const;
  void resume(CheckpointReader& from);
  bool readMarking(CheckpointReader& from);
  void readDomains(CheckpointReader& from);

  // ranks
  [[nodiscard]] bool isElsewhere(const std::vector<Word>& marking) const;
  [[nodiscard]] unsigned ownerOf(const std::vector<Word>& marking) const;
  void sendSuccessors(std::uint32_t signature, TransitionId transition);
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
  StateTree markings;
  NumberLists classes; ///< by marking: domains
  std::vector<Marking> info;
  std::deque<std::uint32_t> waiting;
  std::vector<std::vector<std::uint32_t>> possibleSets;
  NumberTable possibleTable;
  std::vector<std::uint64_t> domainKeys; ///< domains, with the transitions for which they hold
  NumberTable domainTable;
  Exploration result;
  Unsupported failure;
  GraphRecorder::Class initial;

  std::vector<ZoneId> pending;
  std::vector<std::uint32_t> possible; ///< transitions and their target locations
  std::vector<Word> state;
  std::vector<Word> next;
  TransitionSet enabled;
  TransitionSet nextEnabled;
  StepLog log;

  std::optional<Exchange> exchange;
  std::vector<std::vector<Word>> lastSent; ///< by rank: the last marking of the message being made
  std::vector<ZoneId> reached;             ///< domains that are sent
  std::vector<Word> received;
  TransitionSet receivedEnabled;
};

} // namespace proskill::verify
