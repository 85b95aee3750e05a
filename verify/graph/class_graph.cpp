#include "verify/compile/compile.h"
#include "verify/graph/graph_recorder.h"
#include "verify/limits.h"
#include "verify/state/enabled.h"
#include "verify/state/evaluate.h"
#include "verify/state/firing_domains.h"
#include "verify/state/state_layout.h"

#include <algorithm>
#include <deque>

namespace proskill::verify {

namespace {

/// Short lists of numbers in one array. A list that outgrows its place moves to the end.
class Lists {
public:
  std::uint32_t add() {
    heads.emplace_back();
    return static_cast<std::uint32_t>(heads.size() - 1);
  }
  [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t list) const {
    return {pool.data() + heads[list].offset, heads[list].size};
  }
  bool insert(std::uint32_t list, std::uint32_t number) {
    if (std::ranges::find(at(list), number) != at(list).end()) return false;
    Head& head = heads[list];
    if (head.size == head.capacity) move(head);
    pool[head.offset + head.size++] = number;
    return true;
  }
  [[nodiscard]] std::uint64_t bytes() const {
    return heads.capacity() * sizeof(Head) + pool.capacity() * sizeof(std::uint32_t);
  }

private:
  struct Head {
    std::uint64_t offset = 0;
    std::uint32_t size = 0;
    std::uint32_t capacity = 0;
  };

  void move(Head& head) {
    const std::uint64_t offset = pool.size();
    head.capacity = std::max(2U, head.capacity * 2);
    pool.resize(offset + head.capacity);
    std::copy_n(pool.begin() + static_cast<std::ptrdiff_t>(head.offset), head.size,
                pool.begin() + static_cast<std::ptrdiff_t>(offset));
    head.offset = offset;
  }

  std::vector<Head> heads;
  std::vector<std::uint32_t> pool;
};

/// Builds the graph of state classes. All pending classes of a marking are expanded together, to
/// compute what does not depend on time only once.
class ClassGraph {
public:
  /// \param to records edges; null: they are only counted
  ClassGraph(const System& of, LimitWatch& watch, GraphRecorder* to = nullptr)
      : system(of),
        limits(watch),
        recorder(to),
        enabling(of),
        domains(of),
        markings(of.storedWords) {}

  std::expected<Exploration, Unsupported> run() {
    std::vector<Word> first = initialState(system);
    enabling.compute(first.data(), enabled);
    const std::uint32_t marking = add(first, enabled);
    initial = {marking, domains.initial(info[marking].signature)};
    enter(initial.marking, initial.domain);
    for (std::uint64_t count = 0; !waiting.empty(); ++count) {
      constexpr std::uint64_t kBetweenChecks = 64;
      if (count % kBetweenChecks == 0) result.stopped = limits.met(progress());
      if (!result.stopped.empty() || !failure.message.empty()) break;
      const std::uint32_t oldest = waiting.front();
      waiting.pop_front();
      expand(oldest);
    }
    if (!failure.message.empty()) return std::unexpected(failure);
    result.complete = result.stopped.empty();
    result.domains = domainKeys.size();
    result.bytes = bytes();
    result.seconds = limits.seconds();
    return result;
  }

  /// \pre it has finished, with a recorder
  [[nodiscard]] StateGraph recorded() const { return recorder->graph(initial, markings); }

private:
  struct Marking {
    std::uint32_t signature = 0;
    std::uint32_t done = 0; ///< number of expanded classes
    bool waits = false;
  };

  void expand(std::uint32_t id) {
    info[id].waits = false;
    const auto all = classes.at(id);
    pending.assign(all.begin() + info[id].done, all.end());
    info[id].done = static_cast<std::uint32_t>(all.size());
    state.assign(markings.at(id), markings.at(id) + system.words);
    enabling.compute(state.data(), enabled);
    possible.clear();
    eachIn(enabled, [&](TransitionId transition) {
      if (!enabling.isBlocked(transition, enabled)) follow(id, transition);
    });
    countDomains();
  }

  /// Counts domains: the sets of possible transitions and their targets.
  void countDomains() {
    std::uint64_t hash = 0;
    for (auto number : possible) hash = mix(hash, number);
    const auto fresh = static_cast<std::uint32_t>(possibleSets.size());
    auto set = possibleTable.findOrAdd(
        hash, fresh, [&](std::uint32_t other) { return possibleSets[other] == possible; });
    if (set == fresh) possibleSets.push_back(possible);
    for (auto domain : pending) {
      const std::uint64_t key = std::uint64_t{set} << 32 | domain;
      const auto count = static_cast<std::uint32_t>(domainKeys.size());
      auto found = domainTable.findOrAdd(
          mix(0, key), count, [&](std::uint32_t other) { return domainKeys[other] == key; });
      if (found == count) domainKeys.push_back(key);
    }
  }

  /// Fires a transition from every pending class.
  void follow(std::uint32_t source, TransitionId transition) {
    const std::uint32_t signature = info[source].signature;
    next = state;
    nextEnabled = enabled;
    log.clear();
    const Outcome outcome = fire(system, transition, next.data(), log);
    if (outcome == Outcome::GaveUp) return;
    if (outcome == Outcome::Failed) {
      failure = {log.failure, log.origins.empty() ? 0 : log.origins.back()};
      return;
    }
    possible.push_back(transition);
    for (auto part : system.transitions[transition].parts) {
      const auto& instance = system.instances[system.paths[part].instance];
      possible.push_back(
          static_cast<std::uint32_t>(readCell(system, instance.location, next.data())));
    }
    enabling.update(transition, next.data(), nextEnabled);
    const std::uint32_t target = add(next, nextEnabled);
    const std::uint32_t label = recorder ? recorder->label(transition, log) : 0;
    for (auto domain : pending) {
      const ZoneId reached = domains.after(domain, signature, transition, info[target].signature);
      if (reached == kNone) continue;
      ++result.transitions;
      if (recorder) recorder->edge({source, domain}, label, {target, reached});
      enter(target, reached);
    }
  }

  std::uint32_t add(const std::vector<Word>& marking, const TransitionSet& allowed) {
    auto [id, isNew] = markings.add(marking.data());
    if (!isNew) return id;
    classes.add();
    std::vector<TransitionId> clocked;
    eachIn(allowed, [&](TransitionId transition) {
      if (system.transitions[transition].clock != kNone) clocked.push_back(transition);
    });
    info.push_back({domains.signature(enabling.isUrgent(allowed), clocked), 0, false});
    return id;
  }

  void enter(std::uint32_t marking, ZoneId domain) {
    if (classes.at(marking).empty()) ++result.markings; // others are possible except for time
    if (!classes.insert(marking, domain)) return;
    ++result.classes;
    if (info[marking].waits) return;
    info[marking].waits = true;
    waiting.push_back(marking);
  }

  [[nodiscard]] std::uint64_t bytes() const {
    return markings.bytes() + classes.bytes() + domains.bytes() +
           info.capacity() * sizeof(Marking) + waiting.size() * sizeof(std::uint32_t) +
           domainTable.bytes() + domainKeys.capacity() * sizeof(std::uint64_t) +
           (recorder ? recorder->bytes() : 0);
  }
  [[nodiscard]] Progress progress() const {
    return {result.classes, result.markings, waiting.size(), bytes(), limits.seconds()};
  }

  const System& system;
  LimitWatch& limits;
  GraphRecorder* recorder;
  Enabling enabling;
  FiringDomains domains;
  StateStore markings;
  Lists classes; ///< by marking: domains
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
};

/// The system in which every step may wait and none has to happen.
System untimed(System system) {
  for (auto& transition : system.transitions) {
    transition.interval = {};
    transition.urgent = false;
    transition.clock = kNone;
    transition.blocksLater = false;
    auto& blockers = transition.blockers;
    blockers.insert(blockers.end(), transition.laterBlockers.begin(),
                    transition.laterBlockers.end());
    transition.laterBlockers.clear();
  }
  return system;
}

/// State classes contain how long each step may still wait, not since when it has been waiting. So
/// they do not show whether a step with priority has waited long enough. \return why there are no
/// classes
std::optional<Unsupported> withoutClasses(const System& system) {
  const auto late = std::ranges::find_if(system.transitions, &Transition::blocksLater);
  if (late == system.transitions.end()) return std::nullopt;
  return Unsupported{"there are no state classes where what goes first has to wait for its time; "
                     "`--graph-of untimed` has the markings without time",
                     system.paths[late->parts[0]].origin};
}

} // namespace

std::expected<StateGraph, Unsupported> stateGraph(const fiacre::Program& program, GraphKind kind,
                                                  const Options& options) try {
  LimitWatch limits(options);
  auto compiled = compile(program, {}, {}, &limits);
  if (!compiled) return std::unexpected(compiled.error());
  const bool timed = kind != GraphKind::Untimed;
  const System system =
      withStateLayout(timed ? std::move(compiled->system) : untimed(std::move(compiled->system)));
  if (auto why = withoutClasses(system)) return std::unexpected(*why);
  GraphRecorder recorder(system, program.main, kind);
  ClassGraph classes(system, limits, &recorder);
  auto counted = classes.run();
  if (!counted) return std::unexpected(counted.error());
  StateGraph graph;
  if (counted->complete) graph = classes.recorded();
  graph.counts = *counted;
  return graph;
} catch (const LimitMet& limit) {
  StateGraph nothing;
  nothing.counts.stopped = limit.which;
  return nothing;
}

std::expected<Exploration, Unsupported> countClasses(const fiacre::Program& program,
                                                     const Options& options) try {
  LimitWatch limits(options);
  auto compiled = compile(program, {}, {}, &limits);
  if (!compiled) return std::unexpected(compiled.error());
  const System system = withStateLayout(std::move(compiled->system));
  if (auto why = withoutClasses(system)) return std::unexpected(*why);
  return ClassGraph(system, limits).run();
} catch (const LimitMet& limit) {
  return Exploration{.stopped = limit.which};
}

} // namespace proskill::verify
