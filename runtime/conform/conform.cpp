#include "runtime/conform/conform.h"

#include "runtime/conform/claims.h"
#include "runtime/conform/conformance_model.h"
#include "verify/trace/step_description.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace proskill::runtime {

namespace {

using verify::Concrete;
using verify::TransitionId;

constexpr std::size_t kMostStates = 2'000;

std::string secondsText(Nanoseconds date) {
  auto text = fmt::format("{}.{:09}", date / kSecond, date % kSecond);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text + " s";
}

/// Thrown if there are too many states to follow.
struct TooMany {};

} // namespace

/// Keeps the set of states that the model can be in after the recorded steps.
class Follower {
public:
  Follower(const ConformanceModel& of, const ConformOptions& by)
      : model(of), options(by), simulator(of.system, 1), now{simulator.start()} {}

  /// \return why no run explains the step, without its number
  std::optional<ConformResult> follow(const RecordedStep& step) {
    try {
      if (options.tolerance == 0 && noteStop(step)) return std::nullopt;
      if (auto late = stoppedLate(step)) return late;
      auto before = waitUntil(step.date);
      auto after = taken(before, step);
      if (after.empty()) return explained(before, step);
      now = std::move(after);
      date = step.date;
      if (!noteStop(step)) asked.erase(step.what.actor);
      return std::nullopt;
    } catch (const TooMany&) {
      return ConformResult{.verdict = Conformance::Unknown,
                           .at = {},
                           .why = "too many runs of the model have these steps",
                           .assumption = ""};
    }
  }

private:
  using States = std::set<Concrete>;

  /// \return whether the step asks an action to stop. Without a tolerance an action stops as soon
  /// as it is asked to, so that this is not a step of the model.
  bool noteStop(const RecordedStep& step) {
    if (step.stops.empty()) return false;
    asked[step.stops] = step.date;
    return true;
  }

  /// An interrupt from outside might have come later: the recorded request gives its date.
  [[nodiscard]] std::optional<ConformResult> stoppedLate(const RecordedStep& step) const {
    const auto stop = asked.find(step.what.actor);
    if (stop == asked.end() || step.date - stop->second <= options.tolerance) return std::nullopt;
    ConformResult result;
    result.verdict = Conformance::Deviates;
    result.why = fmt::format("`{}` has not stopped before", step.what.actor);
    result.assumption = fmt::format("an action stops at once; that of `{}` took {}",
                                    step.what.actor, secondsText(step.date - stop->second));
    return result;
  }

  /// The states in which the model can reach a date. Steps that recordings do not contain may be
  /// taken before it.
  States waitUntil(Nanoseconds until) {
    States reached;
    States seen = now;
    std::vector<std::pair<Concrete, Nanoseconds>> todo;
    for (const auto& state : now) todo.emplace_back(state, date);
    while (!todo.empty()) {
      auto [state, at] = std::move(todo.back());
      todo.pop_back();
      if (seen.size() > kMostStates) throw TooMany{};
      for (const auto moment : momentsOf(state, at, until))
        for (const auto& [id, since] : state.since) {
          if (!model.isHidden[id] || !simulator.mayWait(state, moment) ||
              !simulator.isRipe(state, id, moment))
            continue;
          auto next = simulator.take(state, id, moment, log);
          if (next && seen.insert(*next).second) todo.emplace_back(std::move(*next), moment);
        }
      if (simulator.mayWait(state, until)) reached.insert(std::move(state));
    }
    blocked = reached.empty() ? std::move(seen) : States();
    return reached;
  }

  /// Dates at which a step that recordings do not contain may be taken: now, when it becomes
  /// enabled, at its deadline, and at the end.
  [[nodiscard]] std::set<Nanoseconds> momentsOf(const Concrete& state, Nanoseconds at,
                                                Nanoseconds until) const {
    std::set<Nanoseconds> all;
    for (const auto& [id, since] : state.since) {
      if (!model.isHidden[id]) continue;
      const auto& interval = model.system.transitions[id].interval;
      const bool isLazy = !interval.upper && !model.environmentIsHidden;
      if (isLazy) continue; // error states of watchdogs change nothing
      const auto add = [&](Nanoseconds moment) {
        if (moment >= at && moment <= until) all.insert(moment);
      };
      add(at);
      add(since + interval.lower + (interval.lowerOpen ? 1 : 0));
      if (interval.upper) add(since + *interval.upper - (interval.upperOpen ? 1 : 0));
      if (model.environmentIsHidden) add(until);
    }
    return all;
  }

  /// Successors of all these states by a recorded step.
  States taken(const States& states, const RecordedStep& step) {
    States after;
    for (const auto& state : states)
      for (const auto id : model.candidates(step)) {
        if (!state.since.contains(id) || !simulator.isRipe(state, id, step.date)) continue;
        auto next = simulator.take(state, id, step.date, log);
        if (next && isThis(step, state, *next)) after.insert(std::move(*next));
      }
    if (after.size() > kMostStates) throw TooMany{};
    return after;
  }

  /// Whether the logged step between these states is the recorded one.
  [[nodiscard]] bool isThis(const RecordedStep& step, const Concrete& before,
                            const Concrete& after) const {
    const auto& origins = model.model.provenance.origins;
    const bool says = std::ranges::any_of(log.origins, [&](fiacre::OriginId id) {
      const auto& it = origins[id];
      const bool isThere =
          it.file == step.what.file && it.begin == step.what.begin && it.end == step.what.end;
      return keyOf(it) == keyOf(step.what) && (isThere || !options.placesMatter);
    });
    return says && changesAs(step, before, after);
  }

  [[nodiscard]] bool changesAs(const RecordedStep& step, const Concrete& before,
                               const Concrete& after) const {
    const auto changes = changesBetween(model.system, before.state, after.state);
    return std::ranges::equal(changes, step.changes, [](const auto& a, const auto& b) {
      return a.variable == b.variable && a.before == b.before && a.after == b.after;
    });
  }

  // --- Reasons for a deviation

  /// An interval of an action or of an event is measured between recorded steps. Whatever the
  /// environment has done in between, no run of the model has these steps at these dates.
  enum class Broken : std::uint8_t { Interval, Other };

  ConformResult explained(const States& before, const RecordedStep& step) {
    ConformResult result;
    result.verdict = Conformance::Deviates;
    const auto broken =
        before.empty() ? explainLate(result, step) : explainStep(result, before, step);
    if (!model.environmentIsHidden || broken == Broken::Interval) return result;
    result.verdict = Conformance::Unknown;
    result.why += "; the environment may have done more than is recorded";
    return result;
  }

  /// Reports that some step must happen before the date of the recorded one.
  Broken explainLate(ConformResult& result, const RecordedStep& step) {
    result.why = "something else has to happen before";
    for (const auto& state : blocked)
      for (const auto& [id, since] : state.since) {
        const auto& interval = model.system.transitions[id].interval;
        if (!interval.upper || model.isHidden[id] || step.date - since < *interval.upper ||
            (step.date - since == *interval.upper && !interval.upperOpen))
          continue;
        if (!simulator.take(state, id, since + *interval.upper, log)) continue;
        const auto what = lastOrigin();
        if (const auto stop = asked.find(what.actor); stop != asked.end()) {
          result.why = fmt::format("`{}` has not stopped", what.actor);
          result.assumption =
              fmt::format("an action stops at once; that of `{}` has not stopped after {}",
                          what.actor, secondsText(step.date - stop->second));
        } else if (model.isOfAction[id]) {
          result.why = fmt::format("`{}` is still running", what.actor);
          result.assumption =
              fmt::format("`{}` has run for {}; its interval promises at most {}", what.actor,
                          secondsText(step.date - since), secondsText(*model.promised[id].upper));
        } else if (model.isOfEvent[id]) {
          result.why = fmt::format("`{}` has not come", what.actor);
          result.assumption =
              fmt::format("`{}` has not come for {}; its `:every` promises at most {}", what.actor,
                          secondsText(step.date - since), secondsText(*model.promised[id].upper));
        } else {
          result.why = fmt::format("before this `{}` {}", what.actor, what.description);
          return Broken::Other;
        }
        return asked.contains(what.actor) ? Broken::Other : Broken::Interval;
      }
    return Broken::Other;
  }

  Broken explainStep(ConformResult& result, const States& before, const RecordedStep& step) {
    result.why = "no run of the model has this step here";
    for (const auto& state : before)
      for (const auto id : model.candidates(step)) {
        const auto since = state.since.find(id);
        if (since == state.since.end() || simulator.isRipe(state, id, step.date)) continue;
        const auto next = simulator.take(state, id, step.date, log);
        if (!next || !isThis(step, state, *next)) continue;
        const auto age = step.date - since->second;
        result.why = "it comes too early";
        if (model.isOfAction[id])
          result.assumption =
              fmt::format("`{}` took {}; its interval promises at least {}", step.what.actor,
                          secondsText(age), secondsText(model.promised[id].lower));
        else if (model.isOfEvent[id])
          result.assumption =
              fmt::format("`{}` came after {}; its `:every` promises at least {}", step.what.actor,
                          secondsText(age), secondsText(model.promised[id].lower));
        return model.isOfAction[id] || model.isOfEvent[id] ? Broken::Interval : Broken::Other;
      }
    if (endsWithoutResult(step))
      result.assumption = "an action ends with one of the results of its skill";
    else if ((result.isElsewhere = isElsewhere(before, step)))
      result.why = "in this program this step is at another place: the recording is of another "
                   "version of it";
    return Broken::Other;
  }

  /// A skill that can be interrupted ends then as if it had been.
  [[nodiscard]] bool endsWithoutResult(const RecordedStep& step) const {
    const auto& said = step.what.description;
    return said == "its action ends without a known result" ||
           (said == "is interrupted" && step.stops.empty() && !asked.contains(step.what.actor));
  }

  /// Whether the recorded step is possible but for its place in the text.
  bool isElsewhere(const States& before, const RecordedStep& step) {
    return std::ranges::any_of(before, [&](const Concrete& state) {
      return std::ranges::any_of(model.candidates(step), [&](TransitionId id) {
        if (!state.since.contains(id) || !simulator.isRipe(state, id, step.date)) return false;
        const auto next = simulator.take(state, id, step.date, log);
        return next && changesAs(step, state, *next);
      });
    });
  }

  [[nodiscard]] fiacre::Origin lastOrigin() const {
    const auto all = mostDescriptiveLast(model.model.provenance, log);
    return all.empty() ? fiacre::Origin{} : model.model.provenance.origins[all.back()];
  }

  const ConformanceModel& model;
  ConformOptions options;
  verify::Simulator simulator;
  States now;
  States blocked; ///< states that could not wait until the last date
  Nanoseconds date = 0;
  std::map<std::string, Nanoseconds> asked; ///< by actor: when it was asked to stop
  verify::StepLog log;
};

class RunJudge::WithModel {
public:
  WithModel(std::unique_ptr<const Executable> run, std::unique_ptr<const ConformanceModel> verified,
            const RecordedHead& head, const ConformOptions& options)
      : executed(std::move(run)),
        model(std::move(verified)),
        follower(*model, options),
        claims(*executed, options.placesMatter) {
    note(claims.initial(head));
  }

  bool step(const RecordedStep& step) {
    if (isDecided) return false;
    note(claims.step(step));
    // a step that no run explains comes before a wrong claim in it
    if (auto wrong = follower.follow(step)) end(std::move(*wrong));
    if (wrongClaim) end(refuted());
    if (isDecided)
      verdict.at = step;
    else
      ++verdict.step;
    return !isDecided;
  }

  /// A wrong call counts at the next step.
  bool call(const RecordedCall& call) {
    if (!isDecided) note(claims.call(call));
    return !isDecided;
  }

  [[nodiscard]] ConformResult result() const {
    if (isDecided || !wrongClaim) return verdict;
    auto last = refuted();
    last.step = verdict.step;
    return last;
  }

private:
  void note(std::optional<std::string> wrong) {
    if (!wrongClaim) wrongClaim = std::move(wrong);
  }
  void end(ConformResult with) {
    if (std::exchange(isDecided, true)) return;
    with.step = verdict.step;
    verdict = std::move(with);
  }
  [[nodiscard]] ConformResult refuted() const {
    return {.verdict = Conformance::Deviates, .at = {}, .why = *wrongClaim, .assumption = ""};
  }

  std::unique_ptr<const Executable> executed;
  std::unique_ptr<const ConformanceModel> model;
  Follower follower;
  Claims claims;
  std::optional<std::string> wrongClaim; ///< the first one
  bool isDecided = false;
  ConformResult verdict;
};

RunJudge::RunJudge(const analysis::Program& of, const ConformOptions& by)
    : program(of), options(by) {}
RunJudge::~RunJudge() = default;

bool RunJudge::onHead(const RecordedHead& head) {
  auto executed = makeExecutable(program, head.mainSkill, head.environment);
  auto model = executed ? conformanceModel(program, **executed, head.mainSkill, head.environment,
                                           options.tolerance)
                        : std::unexpected(executed.error());
  if (model)
    judge = std::make_unique<WithModel>(std::move(*executed), std::move(*model), head, options);
  else
    judge = std::unexpected(std::move(model.error()));
  return judge.has_value();
}

bool RunJudge::onStep(const RecordedStep& step) { return judge && (*judge)->step(step); }

bool RunJudge::onCall(const RecordedCall& call) { return judge && (*judge)->call(call); }

std::expected<ConformResult, NotExecutable> RunJudge::result() const {
  if (!judge) return std::unexpected(judge.error());
  return (*judge)->result();
}

std::expected<ConformResult, NotExecutable>
conform(const analysis::Program& program, const RecordedRun& run, const ConformOptions& options) {
  RunJudge judge(program, options);
  (void)replay(run, judge);
  return judge.result();
}

} // namespace proskill::runtime
