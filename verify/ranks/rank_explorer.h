#pragma once

#include "verify/explore/explorer.h"
#include "verify/ranks/candidates.h"
#include "verify/ranks/distinct_count.h"
#include "verify/ranks/exchange.h"
#include "verify/ranks/recently_sent.h"

namespace proskill::verify {

/// Breadth-first search of the zone graph by several processes. Each state with its zones belongs
/// to the rank that its hash names. Stern and Dill, "Parallelizing the Murphi verifier", CAV 1997.
///
/// The search goes by levels. While the ranks expand their nodes of one level, they send each other
/// the successors; once all have arrived, each adds its own in an order that does not depend on
/// when they came. So counts and verdicts are those of a single rank. The end of a level is
/// detected as in Hoefler, Siebert and Lumsdaine, "Scalable communication protocols for dynamic
/// sparse data exchange", PPoPP 2010: see Ranks::isRoundOver().
class RankExplorer {
public:
  /// A node, and how it is reached; the steps are known to rank 0 only.
  struct Reached {
    Steps steps;
    std::vector<Word> state; ///< its stored words
  };

  /// All ranks call this, and the other functions unless stated otherwise, with equal arguments.
  /// \pre the arguments outlive this
  /// \param onFound called on rank 0, at the end of the level in which a goal is reached
  RankExplorer(const System& system, const std::vector<Goal>& goals, const Reductions& reductions,
               Extrapolation extrapolation, LimitWatch& limits, Ranks& ranks, OnFound onFound);
  RankExplorer(const RankExplorer&) = delete;
  RankExplorer& operator=(const RankExplorer&) = delete;

  /// Call this once. The counts are those of all ranks together.
  Explored run();
  /// The path to a node of any rank. \throw LimitMet, on rank 0
  [[nodiscard]] Reached pathTo(NodePlace place);
  /// What this rank has explored. It alone may call this.
  [[nodiscard]] ZoneGraph& explored() { return graph; }

private:
  /// What a rank has found in a level, or all of them together.
  struct Level {
    std::uint64_t nodes = 0; ///< that are new
    std::uint64_t limited = 0;
    std::uint64_t failed = 0;
    std::uint64_t found = 0; ///< goals
    std::uint64_t classes = 0;
    std::uint64_t markings = 0;
    std::uint64_t transitions = 0;
    std::uint64_t bytes = 0;
  };
  /// A goal that this rank has reached: from where, and the steps from there.
  struct Find {
    std::size_t goal = 0;
    NodePlace from;
    Steps steps;
  };

  // one level
  void start();
  void expandLevel();
  void expand(NodeIndex node);
  void store(NodePlace from);
  [[nodiscard]] unsigned ownerOf(const Word* state) const;
  void sendOnce(unsigned to, const Successor& successor, NodePlace from, const Word* words);
  void send(unsigned to, const Successor& successor, NodePlace from, const Word* words);
  void receive(unsigned from, CheckpointReader& records);
  void receiveRecord(unsigned from, CheckpointReader& records);
  [[nodiscard]] bool isCovered(const Word* state, std::span<const Bound> zone);
  void settle();
  void addNode(const Candidate& candidate);
  [[nodiscard]] SignatureId signatureOf(const std::vector<Word>& state);
  void checkLimits();

  // what the ranks agree on after a level
  [[nodiscard]] bool isOver();
  void addUp();
  void shareFailure();
  void shareFinds();
  void note(const Find& find);
  void show(const Find& find);
  void conclude();
  [[nodiscard]] std::uint64_t count(DistinctCount& domains);
  [[nodiscard]] Progress progress() const;

  // paths
  struct Hop;
  [[nodiscard]] std::vector<Hop> hopsTo(NodePlace place);
  void write(CheckpointWriter& to, NodeIndex node);
  [[nodiscard]] Hop readHop(CheckpointReader& from) const;
  [[nodiscard]] Steps stepsAlong(const std::vector<Hop>& hops);

  const System& system;
  const Reductions& reductions;
  LimitWatch& limits;
  Ranks& ranks;
  OnFound onFound;
  ZoneGraph graph;
  Walker walker;
  OpenGoals goals;
  Expander expander;
  PathSteps pathSteps;
  Exchange exchange;
  Candidates candidates;
  Column parentRanks; ///< by node: 1 + the rank of its parent; 0: it has none
  Column parents;     ///< by node: its number there
  RecentlySent recentlySent;
  std::vector<std::vector<Word>> lastSent; ///< by rank: the last state of the message being made
  std::vector<Find> finds;                 ///< of this level
  Level all;                               ///< of all ranks together, after the last level
  NodeIndex first = 0;                     ///< of the nodes of this level
  std::size_t open = 0;                    ///< number of undecided goals
  Explored result;

  Expansion work;
  std::vector<Word> stored;
  std::vector<Word> received;
  std::vector<Word> whole; ///< a state with the words that are not stored
  TransitionSet enabled;
  StateTree::Path path;
};

} // namespace proskill::verify
