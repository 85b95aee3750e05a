#include "syntax/tree/constants.h"

#include "syntax/text/characters.h"
#include "syntax/tree/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace proskill::syntax {
namespace {

class Fill {
public:
  explicit Fill(const ConstantValues& values) : values(values) {}

  void operator()(Expr& expr) const {
    if (expr.kind != ExprKind::Symbol) return;
    if (const Expr* value = find(expr.name)) {
      expr.kind = ExprKind::Number;
      expr.number = value->number;
      expr.decimal = value->decimal;
    }
  }

  void operator()(Interval& interval) const {
    if (const Expr* value = find(interval.lowerName)) interval.lower = value->number;
    if (const Expr* value = find(interval.upperName)) interval.upper = value->number;
  }

  void operator()(Statement& statement) const {
    const Expr& condition = statement.condition;
    const bool isLone = statement.kind == StatementKind::WaitCondition &&
                        condition.kind == ExprKind::Symbol && statement.branches.empty() &&
                        statement.effects.range.empty();
    if (!isLone || !find(condition.name)) return;
    statement.kind = StatementKind::WaitTime;
    statement.duration.range = condition.range;
    statement.duration.lowerName = statement.duration.upperName = condition.name;
    statement.condition = {};
  }

private:
  [[nodiscard]] const Expr* find(const Name& name) const {
    const auto found = values.find(name.text);
    return found == values.end() ? nullptr : found->second;
  }

  const ConstantValues& values;
};

/// The names and numbers in an order that depends on nothing else.
std::string keyOf(const ConstantValues& values) {
  std::map<std::string_view, const Expr*> sorted(values.begin(), values.end());
  std::string key;
  for (const auto& [name, value] : sorted)
    key += fmt::format("{} {}{}\n", name, toString(value->number), value->decimal ? "." : "");
  return key;
}

std::shared_ptr<const ReadForm> fill(const Form& form, const ConstantValues& values) {
  auto filled = std::make_shared<ReadForm>();
  const Offset back = -form.offset();
  filled->range = form.range.moved(back);
  filled->keyword = {form.keyword.text, form.keyword.range.moved(back)};
  filled->recovered = form.recovered;
  filled->node = form.nodeAsRead();
  forEachPart(filled->node, Fill(values));
  filled->bodyIndex = bodyIndexOf(filled->node);
  return filled;
}

} // namespace

ConstantFiller::ConstantFiller(const ConstantValues& values)
    : values(values), key(std::make_shared<const std::string>(keyOf(values))) {}

std::optional<Form> ConstantFiller::filled(const Form& form, std::string_view text) const {
  FilledForm last = form.lastFilled().get();
  if (!last.constants || *last.constants != *key) {
    last = {key, mentionsAny(text) ? fill(form, values) : nullptr};
    form.lastFilled().set(last);
  }
  if (!last.form) return std::nullopt;
  Form result = Form(last.form).moved(form.offset());
  result.comment = form.comment;
  return result;
}

bool ConstantFiller::mentionsAny(std::string_view text) const {
  for (auto begin = text.begin(); begin != text.end();) {
    const auto end = std::find_if_not(begin, text.end(), isWordCharacter);
    if (begin != end && values.contains(std::string_view(begin, end))) return true;
    begin = std::find_if(end, text.end(), isWordCharacter);
  }
  return false;
}

} // namespace proskill::syntax
