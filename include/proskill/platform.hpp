/* C++ interface of platform.h: a run of an action as an object, and an exception that ends an
   action when it is asked to stop. */
#ifndef PROSKILL_PLATFORM_HPP
#define PROSKILL_PLATFORM_HPP

#include "platform.h"

#include <exception>
#include <string>

namespace proskill {

/* Thrown by functions of Run when the action is asked to stop. Let it leave the action. */
struct Stopped {};

class Run {
public:
  explicit Run(proskill_run run) : number_(run) {}

  proskill_run number() const { return number_; }
  bool stopRequested() const { return proskill_stop_requested(number_); }
  /* Waits up to this many seconds of the run's clock. \return whether the action is asked to stop
   */
  bool wait(double seconds) const { return proskill_wait(number_, seconds); }
  /* Waits likewise, and throws Stopped if the action is asked to stop. */
  void sleep(double seconds) const {
    if (wait(seconds)) throw Stopped();
  }
  void check() const {
    if (stopRequested()) throw Stopped();
  }
  /* File descriptor for poll and select, which becomes readable when the action is asked to stop.
   */
  int stopDescriptor() const { return proskill_stop_descriptor(number_); }

private:
  proskill_run number_;
};

inline void log(const std::string& text) { proskill_log(text.c_str()); }

/* Calls an action, which returns the name of a result. An exception ends the run without a result.
 */
template <class Action> const char* perform(proskill_run run, Action action) {
  try {
    return action();
  } catch (const Stopped&) {
    return PROSKILL_STOPPED;
  } catch (const std::exception& error) {
    proskill_fail(run, error.what());
    return PROSKILL_STOPPED;
  }
}

} // namespace proskill

#endif
