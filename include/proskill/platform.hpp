/* platform.h for C++: a run of an action as an object, and an exception that ends one that is asked
 * to stop. */
#ifndef PROSKILL_PLATFORM_HPP
#define PROSKILL_PLATFORM_HPP

#include "platform.h"

#include <exception>
#include <string>

namespace proskill {

/* Thrown where an action is asked to stop; it leaves the action. */
struct Stopped {};

class Run {
public:
  explicit Run(proskill_run run) : number_(run) {}

  proskill_run number() const { return number_; }
  bool stopRequested() const { return proskill_stop_requested(number_); }
  /* Waits so many seconds of the run's clock. \return whether the action is asked to stop */
  bool wait(double seconds) const { return proskill_wait(number_, seconds); }
  /* The same; throws Stopped where it is. */
  void sleep(double seconds) const {
    if (wait(seconds)) throw Stopped();
  }
  void check() const {
    if (stopRequested()) throw Stopped();
  }
  /* For poll and select: it can be read from when the action is asked to stop. */
  int stopDescriptor() const { return proskill_stop_descriptor(number_); }

private:
  proskill_run number_;
};

inline void log(const std::string& text) { proskill_log(text.c_str()); }

/* Calls an action, which gives the name of a result. What it throws ends the run without one. */
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
