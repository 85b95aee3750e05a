#pragma once

#include <functional>

/// How long work learns that nobody waits for it any more: an editor's next letter makes an
/// analysis useless that is only half done.
namespace proskill::analysis {

/// Ends the work; thrown by `stopIfAsked`. What was half computed is forgotten, and computed anew
/// by whoever asks for it next.
struct Stopped {};

/// While it lives, work of this thread asks now and then whether it is useless.
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

/// For loops that may take more than some milliseconds, in each round. Costs nothing to speak of.
void stopIfAsked();

} // namespace proskill::analysis
