#include "syntax/tree/constants.h"

#include "syntax/tree/parts.h"

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

} // namespace

Form withConstants(const Form& form, const ConstantValues& values) {
  auto filled = std::make_shared<ReadForm>();
  filled->range = form.range;
  filled->keyword = form.keyword;
  filled->recovered = form.recovered;
  filled->node = form.node();
  forEachPart(filled->node, Fill(values));
  filled->bodyIndex = bodyIndexOf(filled->node);
  Form result(std::move(filled));
  result.comment = form.comment;
  return result;
}

} // namespace proskill::syntax
