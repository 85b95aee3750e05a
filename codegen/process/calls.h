#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// How a process calls skills and branches, waits for them and stops them. A callee with one
/// calling process is free again when its `caller` is `None`. A callee with several calling
/// processes stays taken (`returned`) until its caller has read its end, so that no other call
/// changes its status in between.
class Calls {
public:
  /// \param caller the value for the callees' field `caller`
  Calls(Context& context, fiacre::Expr caller) : context(context), me(std::move(caller)) {}

  [[nodiscard]] fiacre::Expr isFree(std::string_view callee);
  /// Calls it. From then on, its status and result are those of no call.
  [[nodiscard]] fiacre::Statement take(std::string_view callee);
  /// Whether it has been called and is not done.
  [[nodiscard]] fiacre::Expr isOutstanding(std::string_view callee);
  /// \pre this process has called it
  [[nodiscard]] fiacre::Expr isDone(std::string_view callee);
  [[nodiscard]] fiacre::Statement acknowledge(std::string_view callee);

  /// Asks it to stop if it runs for this process.
  [[nodiscard]] fiacre::Statement stop(std::string_view callee);
  /// Whether it does not run for this process, or no longer does.
  [[nodiscard]] fiacre::Expr isGone(std::string_view callee);
  /// Whether this process called it and has not yet read its end.
  [[nodiscard]] fiacre::Expr isMine(std::string_view callee) { return equal(caller(callee), me); }
  /// Acknowledges its end if it ran for this process.
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
