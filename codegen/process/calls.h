#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// How one process calls skills and branches, waits for them and stops them. What only one process
/// calls is free again when its `caller` is `None`. What several call stays taken, `returned`,
/// until its caller has seen that it is done, so that no other call can come between and change its
/// status.
class Calls {
public:
  /// `caller` is what the callees' field `caller` gets.
  Calls(Context& context, fiacre::Expr caller) : context(context), me(std::move(caller)) {}

  [[nodiscard]] fiacre::Expr isFree(std::string_view callee);
  /// Calls it. From then on, its status and result are those of no call.
  [[nodiscard]] fiacre::Statement take(std::string_view callee);
  /// Somebody has called it, and it is not done.
  [[nodiscard]] fiacre::Expr isOutstanding(std::string_view callee);
  /// \pre this process has called it.
  [[nodiscard]] fiacre::Expr isDone(std::string_view callee);
  [[nodiscard]] fiacre::Statement acknowledge(std::string_view callee);

  /// Asks it to stop if it runs for this process.
  [[nodiscard]] fiacre::Statement stop(std::string_view callee);
  /// It does not, or no more, run for this process.
  [[nodiscard]] fiacre::Expr isGone(std::string_view callee);
  /// It was called by this process, which has not yet seen its end.
  [[nodiscard]] fiacre::Expr isMine(std::string_view callee) { return equal(caller(callee), me); }
  /// Acknowledges its end if it has run for this process.
  [[nodiscard]] fiacre::Statement release(std::string_view callee);

private:
  [[nodiscard]] bool isShared(std::string_view callee) const;
  [[nodiscard]] fiacre::Expr caller(std::string_view callee) {
    return context.cellField(callee, "caller");
  }
  [[nodiscard]] fiacre::Expr returned(std::string_view callee) {
    return context.cellField(callee, "returned");
  }

  Context& context;
  fiacre::Expr me;
};

} // namespace proskill::codegen
