#include "verify/explore/explorer.h"

#include "verify/explore/conclude.h"
#include "verify/explore/workers.h"

#include <algorithm>

namespace proskill::verify {

Explorer::Explorer(const System& of, const std::vector<Goal>& asked, const Reductions& with,
                   Extrapolation how, LimitWatch& watch, OnFound tell, Pause until, Guide guide,
                   Checkpoint* kept)
    : system(of),
      reductions(with),
      limits(watch),
      onFound(std::move(tell)),
      pause(std::move(until)),
      checkpoint(kept),
      graph(of, with.dropped, how),
      walker(of, graph.enabling, with),
      goals{asked, std::vector<bool>(asked.size()), 0},
      expander(of, goals, with, graph, graph.timing, watch),
      frontier(guide),
      hasOneThread(guide.leads() || with.hull),
      stored(of.storedWords),
      pathSteps(of, with, walker, expander) {
  result.goals.resize(asked.size());
  if (system.clocks.empty()) graph.states.roots.forgetNumbers();
  work.keepsSteps = guide.plan != nullptr;
  open = static_cast<std::size_t>(std::ranges::count_if(asked, [](const Goal& goal) {
    return goal.kind != GoalKind::Unsupported && goal.kind != GoalKind::Run;
  }));
}

Explorer::~Explorer() = default;

Progress Explorer::progress() const {
  return {graph.size(),     graph.states.size(),       frontier.left(),   graph.bytes(),
          limits.seconds(), goals.goals.size() - open, goals.goals.size()};
}

Explored Explorer::run() {
  auto& statistics = result.statistics;
  exploreWithinLimits(statistics, [this] { explore(); });
  result.limited = !statistics.stopped.empty();
  if (result.limited) save();
  conclude(statistics, frontier.left() == 0, result.failure, "all questions decided");
  statistics.classes = graph.size();
  statistics.markings = graph.states.size();
  statistics.domains = countDomains();
  statistics.bytes = graph.bytes();
  statistics.seconds = limits.seconds();
  workers.reset();
  if (checkpoint) return result; // it may be saved again
  return std::move(result);
}

/// The number of distinct zones of the nodes.
std::uint64_t Explorer::countDomains() const {
  Bits zones;
  for (NodeIndex i = 0; i < graph.size(); ++i) zones.insert(graph.zoneOf(i));
  return zones.count();
}

/// \throw LimitMet
void Explorer::explore() {
  start();
  constexpr NodeIndex kBetweenChecks = 8;
  for (NodeIndex count = 0; frontier.left() > 0 && result.failure.empty() && !allDecided();
       ++count) {
    if (count % kBetweenChecks == 0)
      if (auto limit = limits.met(progress(), graph.growth()); !limit.empty())
        throw LimitMet{std::move(limit)};
    if (isToStop()) return;
    saveIfDue();
    const NodeIndex next = frontier.take();
    isHalfway = true;
    graph.expand(next);
    if (!graph.isSubsumed(next)) expand(next);
    isHalfway = false;
  }
}

/// Begins with the initial node, or where an earlier search was saved.
void Explorer::start() {
  if (auto* earlier = checkpoint ? checkpoint->earlier() : nullptr) return resume(*earlier);
  expander.start(work);
  expander.reduce(work, graph.states.nowhere());
  store(work);
  isWhole = true;
}

bool Explorer::isToStop() {
  while (graph.size() >= pause.at.classes ||
         result.statistics.transitions >= pause.at.transitions) {
    const auto next = pause.next ? pause.next() : std::nullopt;
    result.paused = !next;
    if (!next) return true;
    pause.at = *next;
  }
  return false;
}

void Explorer::expand(NodeIndex node) {
  expanding = node;
  if (isForThreads(node)) return store(workers->expansionOf(node));
  const StateId state = graph.stateOf(node);
  graph.states.read(state, stored.data(), nodes);
  expander.load(stored.data(), graph.signatureOf(state), graph.zoneOf(node));
  expander.expand(work);
  expander.reduce(work, nodes);
  if (!work.successors.empty()) frontier.expand(expander.loadedState());
  store(work);
}

/// Whether threads have expanded a node, or are to. Starts them if needed.
bool Explorer::isForThreads(NodeIndex node) {
  if (node < piece.end) return piece.isForThreads;
  const unsigned jobs = hasOneThread ? 1 : limits.jobsFor(graph.size(), frontier.left() + 1);
  if (jobs == 1) return false;
  if (!workers) workers = std::make_unique<Workers>(system, goals, reductions, graph, limits, jobs);
  startPiece(node);
  return piece.isForThreads;
}

/// The next nodes, which threads expand, or this thread alone if that is faster.
void Explorer::startPiece(NodeIndex first) {
  const double now = limits.seconds();
  if (piece.end > 0) gain.add(now - piece.begun, piece.end - piece.first);
  piece = {first, workers->endOfChunk(first), gain.areThreadsFaster(), now};
}

/// Adds to the graph what is possible from the node that is expanded.
void Explorer::store(const Expansion& expansion) {
  for (const auto& notice : expansion.notices) found(notice);
  result.statistics.transitions += expansion.transitions;
  if (!expansion.failure.empty()) {
    result.failure = expansion.failure;
    result.failureOrigin = expansion.failureOrigin;
    return;
  }
  for (const auto& successor : expansion.successors)
    add(successor, expansion.words.data() + successor.state,
        std::span(expansion.steps).subspan(successor.steps, successor.stepsEnd - successor.steps));
}

void Explorer::add(const Successor& successor, const Word* words,
                   std::span<const TransitionId> steps) {
  StateId state = successor.known;
  bool isNew = false;
  if (state == kNone) {
    const auto added = successor.claim == kNone ? graph.states.add(words)
                                                : graph.states.roots.settle(successor.claim);
    state = added.id;
    isNew = added.isNew;
  }
  if (isNew) graph.addState(successor.signature);
  if (!isNew &&
      graph.covers(state, graph.timing.zones().matrix(successor.zone), reductions.inclusion))
    return;
  const bool isJoined = !isNew && reductions.hull;
  const ZoneId zone =
      isJoined ? graph.hullWith(state, successor.zone, reductions.mostHulls) : successor.zone;
  graph.addNode(state, zone, successor.transition, reductions.inclusion);
  frontier.add(words, successor.transition, steps);
}

void Explorer::found(const Notice& notice) {
  if (goals.found[notice.goal]) return;
  Steps steps;
  if (!reductions.hull) {
    if (expanding != kNone) steps = pathTo(expanding);
    append(steps, notice.steps);
  }
  goals.found[notice.goal] = true;
  ++goals.closed;
  --open;
  result.goals[notice.goal] = std::move(steps);
  if (onFound) onFound(notice.goal, *result.goals[notice.goal]);
}

} // namespace proskill::verify
