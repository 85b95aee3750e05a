#include "bridge/bt/emit/counted.h"

#include "analysis/names/names.h"

#include <algorithm>
#include <map>
#include <string>

namespace proskill::bridge::bt {
namespace {

using Does = syntax::StatementKind;
using Is = syntax::ExprKind;

/// Of a counter: its definition, `(set (n 0))`, `(set (n (+ n 1)))`, and a test.
constexpr std::size_t kUses = 5;

bool isNumber(const syntax::Expr& expr, std::int64_t number) {
  return expr.kind == Is::Number && expr.number == syntax::Rational{number, 1};
}

bool isVariable(const syntax::Expr& expr, std::string_view name) {
  return expr.kind == Is::Symbol && expr.name.text == name;
}

/// The only effect of a `set`, or null.
const syntax::Effect* effectOf(const Step& step) {
  const auto& statement = *step.statement;
  const bool isOne =
      !step.counted && statement.kind == Does::Set && statement.effects.items.size() == 1;
  return isOne ? &statement.effects.items.front() : nullptr;
}

/// Whether it is `(set (n (+ n 1)))`.
bool counts(const Step& step, std::string_view counter) {
  const auto* effect = effectOf(step);
  if (!effect || effect->variable.text != counter || effect->value.kind != Is::Add) return false;
  const auto& operands = effect->value.operands;
  return operands.size() == 2 && isVariable(operands[0], counter) && isNumber(operands[1], 1);
}

/// The number in a test as `(< n 3)`.
std::optional<std::int64_t> limitIn(const syntax::Expr& test, Is kind, std::string_view counter) {
  if (test.kind != kind || !isVariable(test.operands.front(), counter)) return {};
  const auto& limit = test.operands.back();
  const bool isCount =
      limit.kind == Is::Number && limit.number.denominator == 1 && limit.number.numerator > 0;
  return isCount ? std::optional(limit.number.numerator) : std::nullopt;
}

/// The condition and the body of an `if` without `else`.
const syntax::Arm* onlyArmOf(const Step& step) {
  const auto& statement = *step.statement;
  const bool isOne = !step.counted && statement.kind == Does::If && statement.arms.size() == 1 &&
                     statement.arms.front().condition;
  return isOne ? &statement.arms.front() : nullptr;
}

bool isJumpTo(const syntax::Statement& statement, std::string_view label) {
  return statement.kind == Does::Goto && statement.name.text == label;
}

bool isJumpTo(const syntax::Block& block, std::string_view label) {
  return block.statements.size() == 1 && isJumpTo(block.statements.front(), label);
}

/// Whether a block does nothing but leave.
bool isWayOut(const syntax::Block& block) {
  if (block.statements.size() != 1) return false;
  const auto kind = block.statements.front().kind;
  return kind == Does::Goto || kind == Does::Success || kind == Does::Failure;
}

/// Whether a jump of other steps leads into these.
bool isEntered(Steps steps, const Exits& jumps) {
  return std::ranges::any_of(steps, [&](const Step& step) {
    return isLabel(step) && jumps.contains(exitTo(step.statement->name.text));
  });
}

/// The steps of a block that jump to each label, by index.
using Origins = std::map<std::string, std::vector<std::size_t>>;

Origins originsIn(Steps steps) {
  Origins origins;
  for (std::size_t i = 0; i < steps.size(); ++i)
    for (const auto& jump : jumpsOf(steps.subspan(i, 1))) origins[jump].push_back(i);
  return origins;
}

/// Whether a jump of another step of the block leads into these.
bool isEntered(Steps steps, std::size_t begin, const Origins& origins) {
  const auto isOther = [&](std::size_t from) {
    return from < begin || from >= begin + steps.size();
  };
  return std::ranges::any_of(steps, [&](const Step& step) {
    if (!isLabel(step)) return false;
    const auto found = origins.find(exitTo(step.statement->name.text));
    return found != origins.end() && std::ranges::any_of(found->second, isOther);
  });
}

} // namespace

CountedLoops::CountedLoops(const analysis::Program& program)
    : program(program), index(analysis::analyse(program).index) {}

std::vector<Step> CountedLoops::grouped(std::vector<Step> steps) const {
  std::vector<Step> result;
  const auto origins = originsIn(steps);
  for (std::size_t i = 0; i < steps.size();) {
    std::size_t length = 0;
    const auto rest = Steps(steps).subspan(i);
    auto loop = loopAtBegin(rest, length);
    if (!loop || isEntered(rest.first(length), i, origins)) {
      result.push_back(steps[i++]);
      continue;
    }
    loop->round = grouped(std::move(loop->round));
    loop->recovery = grouped(std::move(loop->recovery));
    result.push_back({steps[i].statement, nullptr, std::make_shared<Counted>(*std::move(loop))});
    i += length;
  }
  return result;
}

std::optional<Counted> CountedLoops::loopAtBegin(Steps steps, std::size_t& length) const {
  const auto counter = counterOf(steps.front());
  if (counter.empty() || steps.size() < 2) return {};
  if (steps[1].statement->kind == Does::While) {
    length = 2;
    return whileLoop(steps[1], counter);
  }
  const auto counting = std::ranges::find_if(
      steps.subspan(1), [&](const Step& step) { return counts(step, counter); });
  const auto count = static_cast<std::size_t>(counting - steps.begin());
  if (!isLabel(steps[1]) || count + 1 >= steps.size()) return {};
  length = count + 2;
  auto loop = repetition(steps, count, counter);
  return loop ? loop : recovery(steps, count, counter);
}

/// `(set (n 0)) (label again) ROUND (set (n (+ n 1))) (if (< n 3) (goto again))`
std::optional<Counted> CountedLoops::repetition(Steps steps, std::size_t count,
                                                std::string_view counter) const {
  const auto label = steps[1].statement->name.text;
  const auto round = steps.subspan(2, count - 2);
  const auto* arm = onlyArmOf(steps[count + 1]);
  if (!arm || !isJumpTo(arm->body, label) || jumpsOf(round).contains(exitTo(label))) return {};
  const auto times = limitIn(*arm->condition, Is::Less, counter);
  if (!times || !canHold(counter, *times)) return {};
  return Counted{{round.begin(), round.end()}, *times};
}

/// `(set (n 0)) (label again) ROUND (if (>= n 3) LEAVE) RECOVERY (set (n (+ n 1))) (goto again)`
std::optional<Counted> CountedLoops::recovery(Steps steps, std::size_t count,
                                              std::string_view counter) const {
  const auto label = steps[1].statement->name.text;
  if (!isJumpTo(*steps[count + 1].statement, label)) return {};
  for (std::size_t i = 2; i < count; ++i) {
    const auto* arm = onlyArmOf(steps[i]);
    const auto times = arm ? limitIn(*arm->condition, Is::GreaterEqual, counter) : std::nullopt;
    if (!times) continue;
    const auto round = steps.subspan(2, i - 2);
    const auto recovery = steps.subspan(i + 1, count - i - 1);
    const bool isPlain = canHold(counter, *times) && isWayOut(arm->body) &&
                         !jumpsOf(steps.subspan(2, count - 2)).contains(exitTo(label)) &&
                         !isEntered(round, jumpsOf(recovery)) &&
                         !isEntered(recovery, jumpsOf(round));
    auto exits = exitsOf(round);
    exits.erase(kNext);
    auto failures = exitsOf(recovery);
    failures.erase(kNext);
    const auto spent = exitsOf(arm->body);
    if (!isPlain || exits.size() > 1 || !std::ranges::includes(spent, failures)) return {};
    return Counted{
        {round.begin(), round.end()}, *times, {recovery.begin(), recovery.end()}, &arm->body};
  }
  return {};
}

/// `(set (n 0)) (while (< n 3) ROUND (set (n (+ n 1))))`
std::optional<Counted> CountedLoops::whileLoop(const Step& step, std::string_view counter) const {
  const auto times = limitIn(step.statement->condition, Is::Less, counter);
  auto round = stepsOf(step.statement->branches.front());
  if (!times || !canHold(counter, *times) || round.empty() || !counts(round.back(), counter))
    return {};
  round.pop_back();
  if (exitsOf(round).contains(kBreak)) return {};
  return Counted{std::move(round), *times};
}

std::string_view CountedLoops::counterOf(const Step& step) const {
  const auto* effect = effectOf(step);
  if (!effect || !isNumber(effect->value, 0)) return {};
  const auto variable =
      index.symbols().find(analysis::SymbolKind::StateVariable, effect->variable.text);
  const bool isCounter = variable != analysis::kNoSymbol && index.countOf(variable) == kUses;
  return isCounter ? effect->variable.text : std::string_view();
}

bool CountedLoops::canHold(std::string_view counter, std::int64_t number) const {
  const auto& variable = *program.stateVariables.find(counter);
  const auto within = [&](const std::optional<syntax::Expr>& bound, bool isLeast) {
    if (!bound) return true;
    if (bound->kind != Is::Number) return false;
    const syntax::Rational limit{isLeast ? 0 : number, 1};
    return isLeast ? bound->number <= limit : limit <= bound->number;
  };
  return within(variable->min, true) && within(variable->max, false);
}

} // namespace proskill::bridge::bt
