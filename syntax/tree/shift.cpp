#include "syntax/tree/shift.h"

#include <tuple>

namespace proskill::syntax {
namespace {

// The members of each type that are or contain ranges; the visitor below does the rest.
auto members(Name& x) { return std::tie(x.range); }
auto members(Interval& x) { return std::tie(x.range); }
auto members(Expr& x) { return std::tie(x.range, x.head, x.name, x.member, x.operands); }
auto members(Effect& x) { return std::tie(x.variable, x.value, x.range); }
auto members(Effects& x) { return std::tie(x.items, x.range); }
auto members(FieldUse& x) { return std::tie(x.keyword, x.range); }
auto members(Transition& x) { return std::tie(x.from, x.to, x.range); }
auto members(Input& x) { return std::tie(x.name, x.type, x.range); }
auto members(Precondition& x) { return std::tie(x.tag, x.condition, x.range); }
auto members(Invariant& x) { return std::tie(x.tag, x.guard, x.effects, x.range); }
auto members(Outcome& x) {
  return std::tie(x.tag, x.effects, x.postconditionField, x.postcondition, x.range);
}
auto members(Action& x) { return std::tie(x.command, x.arguments, x.range); }
auto members(Interrupt& x) { return std::tie(x.effects, x.range); }
auto members(Argument& x) { return std::tie(x.name, x.value, x.range); }
auto members(Block& x) { return std::tie(x.statements, x.range); }
auto members(CasePattern& x) { return std::tie(x.status, x.tags, x.range); }
auto members(Arm& x) { return std::tie(x.keyword, x.condition, x.pattern, x.body); }
auto members(UnknownForm& x) { return std::tie(x.head, x.name); }
auto members(Include& x) { return std::tie(x.path); }
auto members(Event& x) { return std::tie(x.name, x.fields, x.every, x.effects); }
auto members(Resource& x) { return std::tie(x.name, x.fields, x.capacity); }
auto members(Environment& x) { return std::tie(x.name, x.fields, x.body); }
auto members(ReadForm& x) { return std::tie(x.range, x.keyword, x.node); }
auto members(Statement& x) {
  return std::tie(x.range, x.head, x.name, x.format, x.arguments, x.condition, x.duration,
                  x.effects, x.arms, x.branches);
}
auto members(StateVariable& x) {
  return std::tie(x.name, x.fields, x.states, x.init, x.otherInits, x.min, x.max, x.transitions);
}
auto members(Skill& x) {
  return std::tie(x.name, x.fields, x.inputs, x.preconditions, x.start, x.invariants,
                  x.timeInterval, x.action, x.interrupt, x.successes, x.failures, x.resources,
                  x.body);
}
auto members(Property& x) {
  return std::tie(x.name, x.bodyRange, x.head, x.operands, x.fields, x.after, x.before, x.within,
                  x.forDuration);
}

struct Shift {
  Offset by;

  void operator()(Range& range) const {
    range.begin += by;
    range.end += by;
  }
  template <class T> void operator()(List<T>& items) const {
    for (T& item : items) (*this)(item);
  }
  template <class T> void operator()(std::optional<T>& item) const {
    if (item) (*this)(*item);
  }
  template <class... T> void operator()(std::variant<T...>& item) const { std::visit(*this, item); }
  template <class T>
  requires requires(T& part) { members(part); }
  void operator()(T& part) const {
    std::apply([this](auto&... each) { ((*this)(each), ...); }, members(part));
  }
};

} // namespace

void shift(Range& range, Offset by) { Shift{by}(range); }
void shift(FormNode& node, Offset by) { Shift{by}(node); }
void shift(ReadForm& form, Offset by) { Shift{by}(form); }

void shift(Diagnostic& diagnostic, Offset by) {
  Shift move{by};
  move(diagnostic.location.range);
  for (Related& related : diagnostic.related) move(related.location.range);
  for (Fix& fix : diagnostic.fixes) move(fix.location.range);
}

} // namespace proskill::syntax
