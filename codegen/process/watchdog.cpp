#include "codegen/process/composite.h"

#include "codegen/process/skill_frame.h"
#include "codegen/term/grounds.h"

#include <fmt/format.h>

namespace proskill::codegen {
namespace {

using fiacre::Expr;
using fiacre::Interval;
using fiacre::Statement;

/// Measures a composite skill. A new call waits until the watchdog has seen the last end (the field
/// `watched`), so that two runs are never taken for one. This takes no time.
/// A run that ends too early is known for certain only after some time has passed, while `early`
/// waits for the lower bound. Until then the watchdog may also start with the next run; the choice
/// is nondeterministic, so both are explored.
class Watchdog {
public:
  Watchdog(Context& context, const SkillPlan& skill)
      : context(context),
        skill(skill),
        actor{"watchdog of " + std::string(skill.name()), skill.file()},
        seconds(*skill.skill().timeInterval),
        bounds(context.times.interval(seconds)),
        again(skill.isWatchedAgain()),
        mayBeEarly(bounds.lower > 0 || bounds.lowerOpen) {}

  fiacre::Process make() {
    process.name = context.names.process({"skill", skill.name(), "watchdog"});
    process.origin = place();
    process.comment = fmt::format("{} takes {} s.", skill.name(),
                                  context.origins.excerpt(skill.file(), seconds.range));
    addIdle();
    if (mayBeEarly) addEarly();
    addOnTime();
    if (mayBeEarly) addError("skill_undershoot", true);
    if (bounds.upper) addError("skill_overshoot", false);
    if (usesOver)
      process.variables.push_back({"over", boolType(), boolean(false), "the run has ended early"});
    return std::move(process);
  }

private:
  void addIdle() {
    const auto words =
        causedBy(context, origin("starts measuring"), cell(again ? "watched" : "inv_active"));
    addState(process, "idle", place(),
             sequence({atOnce(), on(cell(again ? "watched" : "inv_active")),
                       at(words, to(mayBeEarly ? "early" : "on_time"))}));
  }

  void addEarly() {
    const Interval exactly{.lower = bounds.lower, .upper = bounds.lower};
    const auto words = origin("reaches the least time");
    std::vector<Statement> ends;
    if (again || context.isRuntime())
      ends = bounds.lowerOpen && !context.isRuntime() ? endAtTheBound() : endSeen();
    else
      ends = {sequence({on(ended()), wait(afterEnd()), at(tooEarly(), to("skill_undershoot"))})};
    ends.insert(ends.begin(), sequence({wait(exactly), at(words, to("on_time"))}));
    addState(process, "early", place(), select(std::move(ends)));
  }

  /// An end exactly at an open bound is too early without any further delay.
  std::vector<Statement> endAtTheBound() {
    auto choice = select({at(tooEarly(), to("skill_undershoot")), at(sawEnd(), to("idle"))});
    return {sequence({atOnce(), on(ended()), release(), std::move(choice)})};
  }

  std::vector<Statement> endSeen() {
    usesOver = true;
    const auto isOver = name("over");
    auto note = sequence({assign(isOver, boolean(true)), at(sawEnd(), stay())});
    auto choice =
        context.isRuntime() ? std::move(note) : select({std::move(note), at(sawEnd(), to("idle"))});
    std::vector<Statement> all{
        sequence(
            {atOnce(), on(conjunction({negation(isOver), ended()})), release(), std::move(choice)}),
        sequence({on(isOver), wait(afterEnd()), assign(isOver, boolean(false)),
                  at(tooEarly(), to("skill_undershoot"))})};
    if (again)
      all.push_back(sequence({atOnce(), on(conjunction({isOver, cell("watched"), ended()})),
                              release(), at(sawEnd(), stay())}));
    return all;
  }

  /// A run that has ended is in time: its bound was reached before any time had passed.
  void addOnTime() {
    auto hasEnded = usesOver ? conjunction({negation(name("over")), ended()}) : ended();
    std::vector<Statement> all{
        sequence({atOnce(), on(std::move(hasEnded)), release(), at(sawEnd(), to("idle"))})};
    if (usesOver)
      all.push_back(sequence({atOnce(), on(name("over")), assign(name("over"), boolean(false)),
                              at(origin("begins with the next run"), to("idle"))}));
    if (bounds.upper) {
      const auto words = origin(fmt::format("detects an overshoot: `{}` takes more than {} s",
                                            skill.name(), toString(*seconds.upper)));
      all.push_back(sequence({wait(afterUpper()), at(words, to("skill_overshoot"))}));
    }
    addState(process, "on_time", place(), select(std::move(all)));
  }

  /// In a model to verify, an error state is final, except that the skill may start again.
  void addError(std::string_view state, bool hasEnded) {
    const std::string comment = hasEnded ? "WARNING: undershoot" : "WARNING: overshoot";
    if (context.isRuntime()) {
      auto see = hasEnded ? sequence({}) : sequence({on(ended()), release()});
      return addState(process, state, place(), sequence({atOnce(), std::move(see), to("idle")}),
                      comment);
    }
    if (!again) return process.states.push_back({std::string(state), place()});
    addState(process, state, place(),
             sequence({atOnce(), on(conjunction({cell("watched"), ended()})), release(),
                       at(sawEnd(), stay())}),
             comment);
  }

  /// Time after an end after which the lower bound was certainly missed. At run time this is one
  /// tick: an end one tick before the bound may be missed, but there is no false alarm.
  [[nodiscard]] Interval afterEnd() const {
    if (context.isRuntime()) return {.lower = 1, .upper = 1};
    if (bounds.lowerOpen) return {.lower = 0, .upper = 0};
    return {.lower = 0, .upper = std::nullopt, .lowerOpen = true};
  }

  /// From the lower bound on, without urgency: the state is reachable, but no run is forced into
  /// it.
  [[nodiscard]] Interval afterUpper() const {
    const auto rest = *bounds.upper - bounds.lower;
    if (!context.isRuntime())
      return {.lower = rest, .upper = std::nullopt, .lowerOpen = !bounds.upperOpen};
    const auto tick = rest + (bounds.upperOpen ? 0 : 1);
    return {.lower = tick, .upper = tick};
  }

  Expr cell(std::string_view field) { return context.cellField(skill.name(), field); }
  Expr ended() { return negation(cell("inv_active")); }
  Statement release() { return again ? assign(cell("watched"), boolean(false)) : sequence({}); }

  OriginId place() { return context.origins.of(actor, seconds.range); }
  OriginId origin(std::string_view words) {
    return context.origins.of(actor, seconds.range, words);
  }
  OriginId sawEnd() { return causedBy(context, origin("stops measuring"), ended()); }
  OriginId tooEarly() {
    const auto words = fmt::format("detects an undershoot: `{}` took less than {} s", skill.name(),
                                   toString(seconds.lower));
    return causedBy(context, origin(words), ended());
  }

  Context& context;
  const SkillPlan& skill;
  Actor actor;
  const syntax::Interval& seconds;
  Interval bounds;
  bool again;
  bool mayBeEarly;
  bool usesOver = false;
  fiacre::Process process;
};

} // namespace

fiacre::Process watchdog(Context& context, const SkillPlan& skill) {
  return Watchdog(context, skill).make();
}

} // namespace proskill::codegen
