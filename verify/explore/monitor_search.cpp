#include "verify/explore/monitor_search.h"

#include "verify/explore/conclude.h"
#include "verify/explore/monitor_graph.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::verify {

namespace {

class MonitorSearch {
public:
  MonitorSearch(const System& of, const Monitor& with, const LiveVariables* live,
                const Bits& dropped, bool errorsAreAsked, LimitWatch& watch)
      : system(of),
        monitor(with),
        liveVariables(live),
        errorsAsked(errorsAreAsked),
        cycles(with.looksForCycles()),
        graph(with, cycles),
        limits(watch),
        enabling(of, dropped),
        timing(of, Extrapolation::LowerUpper),
        states(of.storedWords) {
    for (const auto& location : monitor.locations)
      for (const auto& edge : location.edges)
        for (auto limit : {edge.clock.lower, edge.clock.upper})
          if (limit != kInfinite) most = std::max(most, std::abs(constantOf(limit)));
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
    NodeIndex looked = 512; ///< nodes when cycles were last looked for
    for (; next < graph.size() && !done(); ++next) {
      // A cycle of a part is one of the whole. Each time the part has doubled: the looks together
      // cost no more than one more at the end.
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

  void lookForCycle() { result.evidence = graph.evidenceOfCycle(); }
  [[nodiscard]] bool done() const { return result.evidence || !result.failure.empty(); }
  [[nodiscard]] std::uint64_t bytes() const {
    return zones.bytes() + states.bytes() + timing.bytes() + graph.bytes();
  }
  [[nodiscard]] std::uint64_t growth() const {
    return zones.growth() + states.growth() + timing.growth() + graph.growth() +
           growthOf(signatureOf) + growthOf(headOf);
  }
  [[nodiscard]] Progress progress() const {
    return {graph.size(), states.size(), graph.size() - next, bytes(), limits.seconds()};
  }

  [[nodiscard]] bool seenIn(NodeId condition, const std::vector<Word>& state) const {
    return holdsAt(system, condition, {state.data(), nullptr, nullptr});
  }

  void start() {
    std::vector<Word> state = initialState(system);
    enabling.compute(state.data(), enabled);
    const SignatureId signature = enabling.signature(enabled, timing);
    const auto clocks = static_cast<std::uint32_t>(timing.at(signature).clocks.size());
    for (auto location : monitor.initial)
      arrive(state, signature, location,
             Dbm(clocks + (monitor.locations[location].timed ? 1U : 0U)), kNone, {});
  }

  /// Lets time pass as far as the state allows it, and forgets what nothing compares any more.
  [[nodiscard]] std::optional<Dbm> settled(Dbm zone, const Signature& signature, bool timed,
                                           bool instant) const {
    const auto limitTime = [&] {
      for (std::uint32_t i = 0; i < signature.clocks.size(); ++i)
        if (!zone.constrain(i + 1, 0, signature.invariants[i])) return false;
      return true;
    };
    if (!signature.urgent && !instant) zone.up();
    if (!limitTime()) return std::nullopt;
    auto lower = signature.lower;
    auto upper = signature.upper;
    if (timed) {
      lower.push_back(most);
      upper.push_back(most);
    }
    zone.extrapolate(lower, upper);
    if (!limitTime()) return std::nullopt;
    return zone;
  }

  /// A node for the monitor in `location` as the model has come to a state; `zone` is of that
  /// moment.
  void arrive(const std::vector<Word>& state, SignatureId signature, std::uint32_t location,
              const Dbm& zone, NodeIndex parent, WatchMove move) {
    if (done()) return;
    const auto& at = monitor.locations[location];
    const bool stays = seenIn(at.stay, state);
    if (!stays && std::ranges::none_of(at.edges, [](const auto& edge) { return !edge.ofStep; }))
      return;
    auto made = settled(zone, timing.at(signature), at.timed, !stays);
    if (!made) return;
    std::vector<Word> kept = state;
    if (liveVariables) liveVariables->clean(kept.data());
    const auto [id, isNew] = states.add(kept.data());
    if (isNew) {
      signatureOf.push_back(signature);
      headOf.push_back(kNone);
    }
    const ZoneId zoneId = zones.add(*made);
    const NodeIndex known = find(id, zoneId, location, !stays);
    const auto index = known == kNone ? static_cast<NodeIndex>(graph.size()) : known;
    if (parent != kNone) graph.addArc(parent, index, move);
    if (known != kNone) return;
    graph.addNode({id, zoneId, location, !stays, parent, move, headOf[id]});
    headOf[id] = index;
    if (at.error) result.evidence = graph.evidenceTo(index);
  }

  /// A node that does for a new one; where cycles are looked for, only the very same.
  [[nodiscard]] NodeIndex find(StateId state, ZoneId zone, std::uint32_t location,
                               bool instant) const {
    for (NodeIndex i = headOf[state]; i != kNone; i = graph.at(i).next) {
      const WatchNode& known = graph.at(i);
      if (known.location != location || known.instant != instant) continue;
      if (known.zone == zone) return i;
      if (!cycles && includes(zones.matrix(known.zone), zones.matrix(zone))) return i;
    }
    return kNone;
  }

  void load(const WatchNode& node) {
    if (node.state == loadedState) return;
    const Word* stored = states.at(node.state);
    loaded.assign(system.words, 0);
    std::copy(stored, stored + system.storedWords, loaded.begin());
    enabling.compute(loaded.data(), enabled);
    loadedState = node.state;
  }

  [[nodiscard]] static bool constrain(Dbm& zone, const ClockGuard& guard) {
    const std::uint32_t clock = zone.dimension() - 1;
    if (guard.lower != kZero && !zone.constrain(0, clock, guard.lower)) return false;
    return guard.upper == kInfinite || zone.constrain(clock, 0, guard.upper);
  }

  void expand(NodeIndex index) {
    const WatchNode node = graph.at(index);
    load(node);
    const SignatureId signature = signatureOf[node.state];
    const auto& location = monitor.locations[node.location];
    for (std::uint32_t i = 0; i < location.edges.size(); ++i)
      if (!location.edges[i].ofStep && seenIn(location.edges[i].condition, loaded))
        moveAlone(index, node, signature, i, MoveKind::Silent);
    if (node.instant || done()) return;
    if (fails()) return reportErrors(index, node);
    bool stopped = true;
    const TransitionSet all = enabled;
    eachIn(all, [&](TransitionId transition) {
      stopped = false;
      if (!done() && !enabling.isBlocked(transition, all)) take(index, node, signature, transition);
    });
    if (!stopped) return;
    // Nothing is left to do, so time goes on for ever, beyond all bounds.
    for (std::uint32_t i = 0; i < location.edges.size(); ++i)
      if (location.edges[i].ofStep && location.edges[i].clock.upper == kInfinite &&
          seenIn(location.edges[i].condition, loaded))
        moveAlone(index, node, signature, i, MoveKind::Stutter);
  }

  /// A guard comes to a fault: runs end here, and are no business of the monitor's.
  [[nodiscard]] bool fails() const {
    bool any = false;
    if (hasErrors)
      eachIn(enabled, [&](TransitionId id) { any = any || system.transitions[id].fails; });
    return any;
  }

  void reportErrors(NodeIndex index, const WatchNode& node) {
    const TransitionSet all = enabled;
    eachIn(all, [&](TransitionId id) {
      if (system.transitions[id].fails) take(index, node, signatureOf[node.state], id);
    });
  }

  void moveAlone(NodeIndex index, const WatchNode& node, SignatureId signature, std::uint32_t edge,
                 MoveKind kind) {
    const auto& taken = monitor.locations[node.location].edges[edge];
    const bool timed = monitor.locations[node.location].timed;
    const bool timedAfter = monitor.locations[taken.to].timed;
    Dbm zone = zones.zone(node.zone);
    if (timed && !constrain(zone, taken.clock)) return;
    const std::vector<Word> state = loaded;
    arrive(state, signature, taken.to, watchKept(zone, timed, timedAfter, taken.reset), index,
           {kind, kNone, edge});
  }

  /// The zone with the monitor's clock as the next location wants it.
  [[nodiscard]] static Dbm watchKept(const Dbm& zone, bool timed, bool timedAfter, bool reset) {
    const std::uint32_t others = zone.dimension() - 1 - (timed ? 1U : 0U);
    std::vector<std::uint32_t> from(others);
    for (std::uint32_t i = 0; i < others; ++i) from[i] = i + 1;
    if (timedAfter) from.push_back(timed && !reset ? others + 1 : 0);
    return zone.over(from);
  }

  void take(NodeIndex index, const WatchNode& node, SignatureId signature,
            TransitionId transition) {
    limits.check();
    Dbm zone = zones.zone(node.zone);
    if (!timing.allow(zone, signature, transition)) return;
    ++result.statistics.transitions;
    after = loaded;
    log.clear();
    const Outcome outcome = fire(system, transition, after.data(), log);
    if (outcome == Outcome::GaveUp) return;
    if (outcome == Outcome::Failed) {
      if (errorsAsked) return;
      result.failure = log.failure;
      result.failureOrigin = log.origins.empty() ? 0 : log.origins.back();
      return;
    }
    TransitionSet next = enabled;
    enabling.update(transition, after.data(), next);
    const SignatureId afterSignature = enabling.signature(next, timing);
    Bits events;
    for (auto event : log.events) events.insert(event);
    const Moment moment{loaded.data(), after.data(), &events};
    const auto& location = monitor.locations[node.location];
    const std::vector<Word> reached = after;
    for (std::uint32_t i = 0; i < location.edges.size(); ++i) {
      const auto& edge = location.edges[i];
      if (!edge.ofStep || !holdsAt(system, edge.condition, moment)) continue;
      Dbm own = zone;
      if (location.timed && !constrain(own, edge.clock)) continue;
      std::vector<std::uint32_t> from = timing.kept(signature, transition, afterSignature);
      if (monitor.locations[edge.to].timed)
        from.push_back(location.timed && !edge.reset ? own.dimension() - 1 : 0);
      arrive(reached, afterSignature, edge.to, own.over(from), index,
             {MoveKind::Step, transition, i});
    }
  }

  const System& system;
  const Monitor& monitor;
  const LiveVariables* liveVariables;
  bool errorsAsked;
  bool cycles;
  bool hasErrors = false;
  MonitorGraph graph;
  LimitWatch& limits;
  std::int32_t most = 0; ///< the largest constant that the monitor's clock is compared with
  Enabling enabling;
  Timing timing;
  StateStore states;
  ZoneStore zones;
  std::vector<SignatureId> signatureOf; ///< by state
  std::vector<NodeIndex> headOf;        ///< by state
  Watched result;
  NodeIndex next = 0; ///< to be expanded

  StateId loadedState = kNone;
  std::vector<Word> loaded;
  std::vector<Word> after;
  TransitionSet enabled;
  StepLog log;
};

} // namespace

Watched watchFor(const System& system, const Monitor& monitor, const LiveVariables* liveVariables,
                 const Bits& dropped, bool errorsAreAsked, LimitWatch& limits) {
  return MonitorSearch(system, monitor, liveVariables, dropped, errorsAreAsked, limits).run();
}

} // namespace proskill::verify
