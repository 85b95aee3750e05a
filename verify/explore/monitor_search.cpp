#include "verify/explore/monitor_search.h"

#include "verify/explore/arrivals.h"
#include "verify/explore/conclude.h"
#include "verify/explore/monitor_graph.h"
#include "verify/explore/monitor_zones.h"
#include "verify/explore/open_waits.h"
#include "verify/reduce/live_variables.h"
#include "verify/reduce/monitor_view.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::verify {

namespace {

std::set<std::string> without(std::set<std::string> all, const std::set<std::string>& some) {
  for (const auto& each : some) all.erase(each);
  return all;
}

class MonitorSearch {
public:
  MonitorSearch(const System& of, const Monitor& with, const Reductions& used,
                const std::set<std::string>& obliged, bool withTicks, bool errorsAreAsked,
                LimitWatch& watch, MeasuredClock* clock, std::uint64_t most)
      : system(of),
        monitor(with),
        reductions(used),
        errorsAsked(errorsAreAsked),
        cycles(with.looksForCycles()),
        visible(stepsSeenBy(with, of)),
        limits(watch),
        enabling(of, used.dropped),
        walker(of, enabling, used),
        waits(with.fair ? openWaits(of, without(obliged, with.exempt), used.dropped)
                        : std::vector<OpenWait>{}),
        graph(with, cycles, walker),
        timing(of, Extrapolation::LowerUpper),
        arrivals(walker, timing, watch),
        ticks(withTicks),
        measured(clock),
        mostClasses(most),
        own(with, withTicks, clock, watch),
        states(of.storedWords) {
    timing.callBetween([&zones = timing, &watch] { watch.checkGrowth(zones.growth()); });
    for (const auto& transition : of.transitions) hasErrors = hasErrors || transition.fails;
  }

  Watched run() {
    auto& statistics = result.statistics;
    exploreWithinLimits(statistics, [this] { explore(); });
    conclude(statistics, next == graph.size(), result.failure, "a violation was found");
    statistics.classes = graph.size();
    statistics.markings = states.size();
    statistics.domains = zones.size();
    statistics.bytes = bytes();
    statistics.seconds = limits.seconds();
    return std::move(result);
  }

private:
  /// \throw LimitMet
  void explore() {
    start();
    constexpr NodeIndex kBetweenChecks = 8;
    NodeIndex looked = 512; ///< number of nodes at the last search for cycles
    for (; next < graph.size() && !done(); ++next) {
      if (graph.size() >= mostClasses) {
        result.paused = true;
        return;
      }
      // A cycle in a part of the graph is a cycle of the whole. Searching whenever the graph has
      // doubled costs no more than one extra search at the end.
      if (cycles && next == 2 * looked) {
        looked = next;
        lookForCycle();
        if (done()) break;
      }
      if (next % kBetweenChecks == 0)
        if (auto limit = limits.met(progress(), growth()); !limit.empty())
          throw LimitMet{std::move(limit)};
      expand(next);
    }
    if (!done() && next == graph.size() && cycles) lookForCycle();
  }

  void lookForCycle() {
    const FairNeeds needs{ticks, waits, [this](NodeIndex node, std::size_t wait) {
                            load(graph.at(node).state);
                            return isWaiting(system, waits[wait], loaded.data());
                          }};
    result.evidence = graph.evidenceOfCycle(system, needs);
  }
  [[nodiscard]] bool done() const { return result.evidence || !result.failure.empty(); }
  [[nodiscard]] std::uint64_t bytes() const {
    return zones.bytes() + states.bytes() + timing.bytes() + graph.bytes() + lists.bytes();
  }
  [[nodiscard]] std::uint64_t growth() const {
    return zones.growth() + states.growth() + timing.growth() + graph.growth() + lists.growth() +
           growthOf(signatureOf) + growthOf(headOf);
  }
  [[nodiscard]] Progress progress() const {
    return {graph.size(), states.size(), graph.size() - next, bytes(), limits.seconds()};
  }

  [[nodiscard]] bool seenIn(NodeId condition, const std::vector<Word>& state) const {
    return holdsAt(system, condition, {state.data(), nullptr, nullptr});
  }

  void start() {
    Walk walk = walker.fromStart();
    const Arrival at = arrivals.at(walk);
    const auto clocks = static_cast<std::uint32_t>(timing.at(at.chain.front()).clocks.size());
    for (auto location : monitor.initial) {
      const Dbm zone = arrivals.through(at, Dbm(clocks + own.count(location)), own.count(location));
      arrive(at, location, zone, kNone, {});
    }
  }

  /// Adds a node for the monitor in `location` after the model has reached a state; `zone` is of
  /// that moment.
  /// \param rests no further step follows
  void arrive(const Arrival& there, std::uint32_t location, const Dbm& zone, NodeIndex parent,
              WatchMove move, bool rests = false) {
    if (done()) return;
    if (measured && location == kMeasured) {
      if (!measured->longest) measured->note(zone.at(0, zone.dimension() - 1));
      return;
    }
    const auto& at = monitor.locations[location];
    const bool stays = seenIn(at.stay, there.state);
    if (!stays && std::ranges::none_of(at.edges, [](const auto& edge) { return !edge.ofStep; }))
      return;
    const SignatureId signature = there.chain.back();
    auto made = own.settled(zone, timing.at(signature), location, !stays);
    if (!made) return;
    if (measured && measured->longest && location == kMeasuring)
      measured->note(made->at(made->dimension() - 1, 0));
    std::vector<Word> kept = there.state;
    if (reductions.liveVariables) reductions.liveVariables->clean(kept.data());
    const auto [id, isNew] = states.add(kept.data());
    if (isNew) signatureOf.push_back(signature);
    const ZoneId zoneId = zones.add(*made);
    WatchNode node{id, zoneId, location, !stays, rests, parent, move};
    NodeIndex& head = headOf[listOf(node)];
    node.next = head;
    const NodeIndex known = find(node);
    const auto index = known == kNone ? static_cast<NodeIndex>(graph.size()) : known;
    if (parent != kNone) graph.addArc(parent, index, move);
    if (known != kNone) return;
    graph.addNode(node);
    head = index;
    if (at.error) result.evidence = graph.evidenceTo(index);
  }

  /// The list of the nodes that may cover this one.
  std::uint32_t listOf(const WatchNode& node) {
    const std::uint32_t flags = (node.instant ? 1U : 0U) + (node.rests ? 2U : 0U);
    return lists.get({node.state, node.location, flags, cycles ? node.zone : 0}, [&] {
      headOf.push_back(kNone);
      return static_cast<std::uint32_t>(headOf.size() - 1);
    });
  }

  /// A node that covers the new one. When searching for cycles, only an equal node does.
  [[nodiscard]] NodeIndex find(const WatchNode& node) const {
    for (NodeIndex i = node.next; i != kNone; i = graph.at(i).next) {
      const ZoneId known = graph.at(i).zone;
      if (known == node.zone || includes(zones.matrix(known), zones.matrix(node.zone))) return i;
    }
    return kNone;
  }

  void load(StateId state) {
    if (state == loadedState) return;
    const Word* stored = states.at(state);
    loaded.assign(system.words, 0);
    std::copy(stored, stored + system.storedWords, loaded.begin());
    enabling.compute(loaded.data(), enabled);
    loadedState = state;
  }

  void expand(NodeIndex index) {
    const WatchNode node = graph.at(index);
    load(node.state);
    const SignatureId signature = signatureOf[node.state];
    const auto& location = monitor.locations[node.location];
    for (std::uint32_t i = 0; i < location.edges.size(); ++i)
      if (!location.edges[i].ofStep && seenIn(location.edges[i].condition, loaded))
        moveAlone(index, node, signature, i, MoveKind::Silent);
    if (node.instant || done()) return;
    if (monitor.letsRest()) goOnInTime(index, node);
    if (node.rests) return repeatState(index, node);
    if (fails()) return reportErrors(index, node);
    if (reductions.freeInputs) return expandOpen(index, node);
    bool stopped = true;
    const TransitionSet all = enabled;
    eachIn(all, [&](TransitionId transition) {
      stopped = false;
      if (!done() && !enabling.isBlocked(transition, all))
        take(index, node, {.transition = transition}, loaded);
    });
    if (stopped && !monitor.letsRest()) repeatState(index, node);
  }

  /// No more steps: time passes for ever, beyond all bounds.
  void repeatState(NodeIndex index, const WatchNode& node) {
    const auto& edges = monitor.locations[node.location].edges;
    for (std::uint32_t i = 0; i < edges.size(); ++i)
      if (edges[i].ofStep && edges[i].clock.upper == kInfinite &&
          seenIn(edges[i].condition, loaded))
        moveAlone(index, node, signatureOf[node.state], i, MoveKind::Stutter);
  }

  /// Adds a tick; if no step is forced, the run may also end here.
  void goOnInTime(NodeIndex index, const WatchNode& node) {
    const SignatureId signature = signatureOf[node.state];
    const Arrival here{loaded, {signature}, {}};
    if (const auto zone = own.ticked(zones.zone(node.zone), node.location))
      arrive(here, node.location, *zone, index, {MoveKind::Tick}, node.rests);
    const auto& now = timing.at(signature);
    const bool mayRest = !now.urgent && std::ranges::all_of(now.invariants, [](Bound limit) {
      return limit == kInfinite;
    });
    if (mayRest && !node.rests)
      arrive(here, node.location, zones.zone(node.zone), index, {MoveKind::Rest}, true);
  }

  /// The state represents all values of its open variables. The environment can always change its
  /// inputs.
  void expandOpen(NodeIndex index, const WatchNode& node) {
    const FreeInputs& open = *reductions.freeInputs;
    std::vector<Word> state = loaded;
    eachIn(open.candidates(state.data(), enabled), [&](TransitionId transition) {
      if (done() || open.staysWithin(transition, loaded.data())) return;
      WatchMove move{.transition = transition};
      open.eachFiring(transition, state.data(), [&] {
        take(index, node, move, state);
        ++move.choice;
        return false;
      });
    });
  }

  /// Whether a guard fails: runs end here, and the monitor ignores them.
  [[nodiscard]] bool fails() const {
    bool any = false;
    if (hasErrors)
      eachIn(enabled, [&](TransitionId id) { any = any || system.transitions[id].fails; });
    return any;
  }

  void reportErrors(NodeIndex index, const WatchNode& node) {
    const TransitionSet all = enabled;
    eachIn(all, [&](TransitionId id) {
      if (system.transitions[id].fails) take(index, node, {.transition = id}, loaded);
    });
  }

  void moveAlone(NodeIndex index, const WatchNode& node, SignatureId signature, std::uint32_t edge,
                 MoveKind kind) {
    const auto& taken = monitor.locations[node.location].edges[edge];
    Dbm zone = zones.zone(node.zone);
    if (!own.constrain(zone, node.location, taken)) return;
    arrive({loaded, {signature}, {}}, taken.to, own.after(zone, node.location, taken), index,
           {kind, kNone, edge}, node.rests);
  }

  /// Takes a step of the model from the loaded state, with some values of its open variables.
  void take(NodeIndex index, const WatchNode& node, WatchMove move,
            const std::vector<Word>& state) {
    limits.check();
    const TransitionId transition = move.transition;
    const SignatureId signature = signatureOf[node.state];
    Dbm zone = zones.zone(node.zone);
    if (!timing.allow(zone, signature, transition)) return;
    ++result.statistics.transitions;
    Walk walk{state, enabledIn(state, transition), {}};
    log.clear();
    const Outcome outcome = fire(system, transition, walk.state.data(), log);
    if (outcome == Outcome::GaveUp) return;
    if (outcome == Outcome::Failed) return noticeError();
    const std::vector<Word> after = walk.state;
    enabling.update(transition, walk.state.data(), walk.enabled);
    walker.normalise(walk);
    const Arrival there = arrivals.at(walk);
    const auto from = timing.kept(signature, transition, there.chain.front());
    move.kind = MoveKind::Step;
    const std::uint32_t at = node.location;
    if (!visible.contains(transition)) return arriveBy(there, node, at, zone, from, index, move);
    Bits events;
    for (auto event : log.events) events.insert(event);
    const Moment moment{state.data(), after.data(), &events};
    for (move.edge = 0; move.edge < monitor.locations[at].edges.size(); ++move.edge) {
      const auto& edge = monitor.locations[at].edges[move.edge];
      if (edge.ofStep && holdsAt(system, edge.condition, moment))
        arriveBy(there, node, edge.to, zone, from, index, move);
    }
  }

  /// The monitor takes part in the step, or does not observe it. \param from clocks that keep
  /// running
  void arriveBy(const Arrival& there, const WatchNode& node, std::uint32_t to, Dbm zone,
                std::vector<std::uint32_t> from, NodeIndex index, WatchMove move) {
    const auto& edges = monitor.locations[node.location].edges;
    const MonitorEdge* edge = move.edge == kNone ? nullptr : &edges[move.edge];
    if (edge && !own.constrain(zone, node.location, *edge)) return;
    own.appendOwn(from, zone, node.location, edge);
    arrive(there, to, arrivals.through(there, zone.over(from), own.count(to)), index, move);
  }

  /// The transitions enabled in the loaded state with other values of open variables, as far as
  /// they affect the transition.
  [[nodiscard]] TransitionSet enabledIn(const std::vector<Word>& state, TransitionId transition) {
    TransitionSet there = enabled;
    if (!reductions.freeInputs || state == loaded) return there;
    for (auto variable : reductions.freeInputs->readBy(transition))
      enabling.refresh(reductions.freeInputs->all()[variable].readers, state.data(), there);
    return there;
  }

  /// An error ends the search unless somebody asks for errors.
  void noticeError() {
    if (errorsAsked) return;
    result.failure = log.failure;
    result.failureOrigin = log.origins.empty() ? 0 : log.origins.back();
  }

  const System& system;
  const Monitor& monitor;
  const Reductions& reductions;
  bool errorsAsked;
  bool cycles;
  bool hasErrors = false;
  Bits visible; ///< transitions
  LimitWatch& limits;
  Enabling enabling;
  Walker walker;
  std::vector<OpenWait> waits;
  MonitorGraph graph;
  Timing timing;
  Arrivals arrivals;
  bool ticks;
  MeasuredClock* measured; ///< null: nothing is measured
  std::uint64_t mostClasses;
  MonitorZones own;
  StateStore states;
  ZoneStore zones;
  LargeVector<SignatureId> signatureOf; ///< by state
  Memo lists;                           ///< numbers of lists of nodes
  LargeVector<NodeIndex> headOf;        ///< by list
  Watched result;
  NodeIndex next = 0; ///< to expand

  StateId loadedState = kNone;
  std::vector<Word> loaded;
  TransitionSet enabled;
  StepLog log;
};

} // namespace

Watched watchFor(const System& system, const Monitor& monitor, const Reductions& reductions,
                 const std::set<std::string>& obliged, bool errorsAreAsked, LimitWatch& limits,
                 MeasuredClock* measured, std::uint64_t most) {
  const auto search = [&](bool ticks) {
    return MonitorSearch(system, monitor, reductions, obliged, ticks, errorsAreAsked, limits,
                         measured, most)
        .run();
  };
  // without ticks there are fewer zones; if there is no cycle, there is none with ticks
  Watched found = search(false);
  if (!monitor.fair || !found.evidence) return found;
  Exploration before = found.statistics;
  before.complete = true; // complete for this question
  before.stopped.clear();
  found = search(true);
  add(found.statistics, before);
  return found;
}

} // namespace proskill::verify
