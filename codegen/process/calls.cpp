#include "codegen/process/calls.h"

namespace proskill::codegen {

using fiacre::Expr;
using fiacre::Statement;

bool Calls::isShared(std::string_view callee) const {
  const auto* skill = context.plan.find(callee);
  return skill && skill->shared();
}

Expr Calls::isFree(std::string_view callee) { return equal(caller(callee), name("None")); }

Statement Calls::take(std::string_view callee) {
  std::vector<Statement> all{assign(caller(callee), me)};
  if (const auto* skill = context.plan.find(callee)) {
    all.push_back(assign(context.cellField(callee, "status"), name("no_status")));
    if (skill->resultIsRead)
      all.push_back(assign(context.cellField(callee, "val"), name("no_result")));
  }
  return sequence(std::move(all));
}

Expr Calls::isOutstanding(std::string_view callee) {
  auto isCalled = negation(isFree(callee));
  if (!isShared(callee)) return isCalled;
  return conjunction({std::move(isCalled), negation(returned(callee))});
}

Expr Calls::isDone(std::string_view callee) {
  return isShared(callee) ? returned(callee) : isFree(callee);
}

Statement Calls::acknowledge(std::string_view callee) {
  if (!isShared(callee)) return sequence({});
  return sequence({assign(returned(callee), boolean(false)), assign(caller(callee), name("None"))});
}

Statement Calls::stop(std::string_view callee) {
  const auto flag = context.cellField(callee, "stop");
  if (!isShared(callee)) return assign(flag, negation(isFree(callee)));
  auto runsForMe = conjunction({equal(caller(callee), me), negation(returned(callee))});
  return assign(flag, disjunction({flag, std::move(runsForMe)}));
}

Expr Calls::isGone(std::string_view callee) {
  if (!isShared(callee)) return isFree(callee);
  return disjunction({negation(equal(caller(callee), me)), returned(callee)});
}

Statement Calls::release(std::string_view callee) {
  if (!isShared(callee)) return sequence({});
  const auto mine = isMine(callee);
  return sequence({assign(returned(callee), conjunction({returned(callee), negation(mine)})),
                   assign(caller(callee), conditional(mine, name("None"), caller(callee)))});
}

} // namespace proskill::codegen
