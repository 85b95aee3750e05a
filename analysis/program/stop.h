#pragma once

#include <functional>

/// Cooperative cancellation: an edit makes an unfinished analysis useless.
namespace proskill::analysis {

/// Thrown by `stopIfAsked` to end the work. Partial results are dropped; whoever needs them next
/// computes them again.
struct Stopped {};

/// While it exists, work of this thread checks from time to time whether it is cancelled.
class StopWhen {
public:
  using Question = std::function<bool()>;

  explicit StopWhen(Question isUseless);
  ~StopWhen();
  StopWhen(const StopWhen&) = delete;
  StopWhen& operator=(const StopWhen&) = delete;

private:
  friend void stopIfAsked();
  Question isUseless;
  const StopWhen* outer;
};

/// Call this in each iteration of loops that may take more than a few milliseconds. The cost is
/// negligible.
void stopIfAsked();

} // namespace proskill::analysis
