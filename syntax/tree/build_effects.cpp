#include "syntax/diagnostics/codes.h"
#include "syntax/tree/build.h"

namespace proskill::syntax {
namespace {

Effect effectOf(Builder& builder, const Node& node) {
  Parts parts(node);
  Effect effect;
  effect.range = node.range;
  effect.variable = builder.nameOf(*parts.take());
  const Node* value = parts.take();
  if (!value) {
    Offset end = effect.variable.range.end;
    effect.value.range = {end, end};
    builder.report(Code::MalformedEffects, node.range,
                   fmt::format("`{}` has no value", effect.variable.text));
    return effect;
  }
  effect.value = expressionOf(builder, *value);
  builder.reportSurplus(parts, fmt::format("the value of `{}`", effect.variable.text));
  return effect;
}

void readOne(Builder& builder, const Node& node, Effects& effects) {
  if (node.kind == NodeKind::Effect)
    effects.items.push_back(effectOf(builder, node));
  else if (!isDamaged(node))
    builder.report(Code::MalformedEffects, node.range,
                   fmt::format("`{}` is not an effect", builder.quoted(node)));
}

/// Reports `(a X) (b Y)` where a list of both was meant.
void reportUnlisted(Builder& builder, Range range) {
  auto& diagnostic =
      builder.report(Code::MalformedEffects, range, "several effects need parentheses around them");
  diagnostic.fixes.push_back(
      {"put them in parentheses", {0, range}, fmt::format("({})", builder.textOf(range))});
}

void readList(Builder& builder, const Node& list, Effects& effects) {
  Parts items(list);
  if (!items.peek()) builder.report(Code::EmptyForm, list.range);
  while (const Node* item = items.take()) readOne(builder, *item, effects);
}

/// Reads an effect that is not in a list, and those that follow it.
void readUnlisted(Builder& builder, const Node& first, Parts& parts, Effects& effects) {
  readOne(builder, first, effects);
  bool alone = !parts.peek() || parts.peek()->kind != NodeKind::Effect;
  if (alone) return builder.reportSurplus(parts, "the effects");
  while (const Node* next = parts.take()) {
    readOne(builder, *next, effects);
    effects.range.end = next->range.end;
  }
  reportUnlisted(builder, effects.range);
}

} // namespace

Effects takeEffects(Builder& builder, Parts& parts, const Name& head) {
  Effects effects;
  effects.range = {head.range.end, head.range.end};
  const Node* first = parts.take();
  if (!first) {
    builder.report(Code::MissingValue, head.range, head.text, "effects, such as `(motion Free)`");
    return effects;
  }
  effects.range = first->range;
  if (first->kind == NodeKind::Effect) {
    readUnlisted(builder, *first, parts, effects);
  } else if (first->kind == NodeKind::EffectList) {
    readList(builder, *first, effects);
    builder.reportSurplus(parts, "the effects");
  } else {
    readOne(builder, *first, effects); // a word: what follows belongs to the same error
  }
  return effects;
}

} // namespace proskill::syntax
