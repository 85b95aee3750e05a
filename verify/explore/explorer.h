#pragma once

#include "verify/checkpoint/checkpoint.h"
#include "verify/checkpoint/parts.h"
#include "verify/explore/path_steps.h"
#include "verify/guide/frontier.h"
#include "verify/threads/thread_gain.h"
#include "verify/verify.h"

#include <functional>
#include <memory>
#include <span>
#include <unordered_map>

namespace proskill::verify {

class Workers;

/// The results of an exploration.
struct Explored {
  std::vector<std::optional<Steps>> goals; ///< by goal: the steps that reach it
  Exploration statistics;
  bool paused = false;
  bool limited = false; ///< a limit ended it
  std::string failure;  ///< an error of the model, such as a value out of range
  fiacre::OriginId failureOrigin = 0;
};

/// Receives the index of a goal and the steps that reach it.
using OnFound = std::function<void(std::size_t, const Steps&)>;

/// How much a search has found.
struct SearchSize {
  std::uint64_t classes = UINT64_MAX;
  std::uint64_t transitions = UINT64_MAX;
};

/// A size at which an exploration that turns out to be long asks whether to go on.
struct Pause {
  SearchSize at; ///< whichever number is reached first
  /// Returns when to ask again; nullopt: the search is to stop. Empty: it is to stop.
  std::function<std::optional<SearchSize>()> next;
};

/// Search of the zone graph: breadth-first, or led by a guide.
///
/// A long breadth-first search uses several threads: these compute what is possible from the next
/// nodes of the frontier, and one thread adds it to the graph, in the order of the nodes. So the
/// graph, the verdicts and the paths are those of one thread. Where several threads are slower, one
/// does everything.
class Explorer {
public:
  /// \pre the arguments outlive this
  /// \param onFound called for each goal as soon as it is reached
  /// \param checkpoint keeps the state of the search, and may have an earlier one from which it
  /// goes on; may be null, and is if a guide leads the search
  Explorer(const System& system, const std::vector<Goal>& goals, const Reductions& reductions,
           Extrapolation extrapolation, LimitWatch& limits, OnFound onFound = {}, Pause pause = {},
           Guide guide = {}, Checkpoint* checkpoint = nullptr);
  Explorer(const Explorer&) = delete;
  Explorer& operator=(const Explorer&) = delete;
  ~Explorer();

  /// Call this once.
  Explored run();
  /// Saves the state of the search, unless it could not be read or an error ended it.
  void save();
  void saveIfDue();
  [[nodiscard]] const ZoneGraph& explored() const { return graph; }
  [[nodiscard]] ZoneGraph& explored() { return graph; }
  /// The same for who looks for numbers of states; see RootTable::forgetNumbers().
  [[nodiscard]] ZoneGraph& exploredWithNumbers() {
    graph.states.roots.learnNumbers();
    return graph;
  }
  /// The transitions from the initial state to a node, including the steps fired alone.
  [[nodiscard]] Steps pathTo(NodeIndex index) const;

private:
  void explore();
  void start();
  void write(CheckpointWriter& to) const;
  void writeGoals(CheckpointWriter& to) const;
  void writeSignatures(CheckpointWriter& to) const;
  void writeNodes(CheckpointWriter& to, const ZoneRanks& zones) const;
  void resume(CheckpointReader& from);
  void readGoals(CheckpointReader& from);
  void readSignatures(CheckpointReader& from);
  void readZones(CheckpointReader& from);
  void readNodes(CheckpointReader& from);
  bool readNode(CheckpointReader& from);
  bool addSaved(CheckpointReader& from, StateId state, ZoneId zone, TransitionId step);
  void expand(NodeIndex node);
  [[nodiscard]] bool isForThreads(NodeIndex node);
  void startPiece(NodeIndex first);
  void store(const Expansion& expansion);
  void add(const Successor& successor, const Word* words, std::span<const TransitionId> steps);
  void found(const Notice& notice);
  [[nodiscard]] bool isToStop();
  [[nodiscard]] bool allDecided() const { return open == 0 && !goals.goals.empty(); }
  [[nodiscard]] Progress progress() const;
  [[nodiscard]] std::uint64_t countDomains() const;
  [[nodiscard]] PathNode placeOf(NodeIndex node) const;
  [[nodiscard]] const Steps& legTo(NodeIndex index) const;

  const System& system;
  const Reductions& reductions;
  LimitWatch& limits;
  OnFound onFound;
  Pause pause;
  Checkpoint* checkpoint;
  ZoneGraph graph;
  Walker walker;
  OpenGoals goals;
  mutable Expander expander;
  /// Consecutive nodes that are expanded in one way.
  struct Piece {
    NodeIndex first = 0;
    NodeIndex end = 0;
    bool isForThreads = false;
    double begun = 0; ///< seconds
  };
  std::unique_ptr<Workers> workers; ///< once the search is long
  ThreadGain gain;
  Piece piece; ///< of a long search
  Explored result;
  Frontier frontier;
  bool hasOneThread;
  std::size_t open = 0; ///< number of undecided goals

  bool isWhole = false;   ///< the graph is that of the nodes expanded so far
  bool isHalfway = false; ///< the last node was taken from the frontier, but not expanded
  NodeIndex expanding = kNone;
  StateTree::Path nodes;    ///< of the state that is expanded
  std::vector<Word> stored; ///< the state that is being expanded
  Expansion work;
  mutable PathSteps pathSteps;
  mutable std::unordered_map<NodeIndex, Steps> legs; ///< the last steps to a node, from its parent
};

} // namespace proskill::verify
