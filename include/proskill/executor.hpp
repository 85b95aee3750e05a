/* C++ interface of executor.h: programs and executors as objects, actions as functions that may
   throw, and failures as exceptions. Requires C++11. */
#ifndef PROSKILL_EXECUTOR_HPP
#define PROSKILL_EXECUTOR_HPP

#include "executor.h"

#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace proskill {

/* A call that failed. */
class Error : public std::runtime_error {
public:
  explicit Error(proskill_error code) : std::runtime_error(proskill_error_text()), number(code) {}
  proskill_error code() const { return number; }

private:
  proskill_error number;
};

inline void check(proskill_error code) {
  if (code != PROSKILL_OK) throw Error(code);
}

class Program {
public:
  explicit Program(const std::string& file) {
    proskill_program* loaded = nullptr;
    check(proskill_program_load(file.c_str(), &loaded));
    program.reset(loaded);
  }
  const proskill_program* get() const { return program.get(); }

private:
  struct Free {
    void operator()(proskill_program* it) const { proskill_program_free(it); }
  };
  std::unique_ptr<proskill_program, Free> program;
};

/* Initial value of options. */
inline proskill_options defaultOptions() {
  const proskill_options options = PROSKILL_OPTIONS;
  return options;
}

inline proskill_view_options defaultViewOptions() {
  const proskill_view_options options = PROSKILL_VIEW_OPTIONS;
  return options;
}

/* A start of an action. Copies may be used in any thread, as long as the executor exists. */
class Start {
public:
  Start(proskill_executor* of, proskill_run number) : executor(of), run(number) {}

  proskill_run number() const { return run; }
  bool stopRequested() const { return proskill_executor_stop_requested(executor, run); }
  /* Ends the action with one of its results. */
  void finish(const std::string& result) const {
    check(proskill_executor_finish(executor, run, result.c_str()));
  }
  /* The same after this many seconds of the run's clock. */
  void finishAfter(double seconds, const std::string& result) const {
    check(proskill_executor_finish_after(executor, run, seconds, result.c_str()));
  }
  /* Ends an action that was asked to stop. */
  void stopped() const { check(proskill_executor_finish(executor, run, PROSKILL_STOPPED)); }
  void stoppedAfter(double seconds) const {
    check(proskill_executor_finish_after(executor, run, seconds, PROSKILL_STOPPED));
  }
  /* Ends the action with an error, as an exception does that leaves it. */
  void fail(const std::string& why) const {
    check(proskill_executor_fail(executor, run, why.c_str()));
  }

private:
  proskill_executor* executor;
  proskill_run run;
};

/* The arguments of an action, valid until its function returns. */
class Arguments {
public:
  Arguments(const proskill_value* first, size_t count) : all(first), length(count) {}
  size_t size() const { return length; }
  const proskill_value& operator[](size_t index) const {
    if (index >= length) throw std::out_of_range("the action has fewer arguments");
    return all[index];
  }
  const proskill_value* begin() const { return all; }
  const proskill_value* end() const { return all + length; }

private:
  const proskill_value* all;
  size_t length;
};

/* One run of a program. Functions that it calls may throw: an exception of an action ends it with a
   fault, one of the observer leaves proceed() or run(). */
class Executor {
public:
  using Begin = std::function<void(Start start, Arguments arguments)>;
  using Stop = std::function<void(Start start)>;
  using Observer = std::function<void(const proskill_entry& entry)>;

  explicit Executor(const Program& program, const proskill_options& options = defaultOptions()) {
    proskill_executor* made = nullptr;
    check(proskill_executor_new(program.get(), &options, &made));
    executor.reset(made);
  }
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /* Says who performs the action of a basic skill. Both return soon. */
  void perform(const std::string& skill, Begin begin, Stop stop = Stop()) {
    actions.push_back(Action{std::move(begin), std::move(stop)});
    check(proskill_executor_perform(get(), skill.c_str(), beginAction,
                                    actions.back().stop ? stopAction : nullptr, &actions.back()));
  }
  void observe(Observer with) {
    observer = std::move(with);
    check(proskill_executor_observe(get(), reportEntry, this));
  }

  /* Records the run in a file, in MCAP if its name ends in `.mcap`. */
  void record(const std::string& file) { check(proskill_executor_record(get(), file.c_str())); }
  /* Why the recording has ended before the run; empty if it has not. */
  std::string recordingError() const { return proskill_executor_recording_error(get()); }

  /* Serves a page that shows the run. Returns its address. */
  std::string serveView(const proskill_view_options& options = defaultViewOptions()) {
    check(proskill_executor_serve_view(get(), &options));
    return viewAddress();
  }
  /* "" if there is no page. */
  std::string viewAddress() const { return proskill_executor_view_address(get()); }

  void start() { check(proskill_executor_start(get())); }
  void proceed() { finished(proskill_executor_proceed(get())); }
  void run() { finished(proskill_executor_run(get())); }
  int descriptor() const { return proskill_executor_descriptor(get()); }
  double timeout() const { return proskill_executor_timeout(get()); }

  proskill_phase phase() const { return proskill_executor_phase(get()); }
  bool ended() const { return phase() == PROSKILL_ENDED; }
  proskill_end end() const { return proskill_executor_end(get()); }
  std::string outcome() const { return proskill_executor_outcome(get()); }
  double time() const { return proskill_executor_time(get()); }
  uint64_t steps() const { return proskill_executor_steps(get()); }
  uint64_t faults() const { return proskill_executor_faults(get()); }
  std::string value(const std::string& name) const {
    const char* text = nullptr;
    check(proskill_executor_value(get(), name.c_str(), &text));
    return text;
  }

  /* For any thread. */
  void report(const std::string& event) { check(proskill_executor_report(get(), event.c_str())); }
  void reportAfter(double seconds, const std::string& event) {
    check(proskill_executor_report_after(get(), seconds, event.c_str()));
  }
  void interrupt(const std::string& skill) {
    check(proskill_executor_interrupt(get(), skill.c_str()));
  }
  void log(const std::string& text) { check(proskill_executor_log(get(), text.c_str())); }
  void stop() { proskill_executor_stop(get()); }

  proskill_executor* get() const { return executor.get(); }

private:
  struct Action {
    Begin begin;
    Stop stop;
  };
  struct Free {
    void operator()(proskill_executor* it) const { proskill_executor_free(it); }
  };

  template <class Call> static void guarded(proskill_executor* by, proskill_run run, Call call) {
    try {
      call();
    } catch (const std::exception& error) {
      proskill_executor_fail(by, run, error.what());
    } catch (...) {
      proskill_executor_fail(by, run, "an exception has left it");
    }
  }
  static void beginAction(proskill_executor* by, proskill_run run, const proskill_value* arguments,
                          size_t count, void* data) {
    guarded(by, run, [=] {
      static_cast<Action*>(data)->begin(Start(by, run), Arguments(arguments, count));
    });
  }
  static void stopAction(proskill_executor* by, proskill_run run, void* data) {
    guarded(by, run, [=] { static_cast<Action*>(data)->stop(Start(by, run)); });
  }
  static void reportEntry(proskill_executor*, const proskill_entry* entry, void* data) {
    Executor& self = *static_cast<Executor*>(data);
    try {
      self.observer(*entry);
    } catch (...) {
      if (!self.thrown) self.thrown = std::current_exception();
      throw; /* so that proceed() returns */
    }
  }
  void finished(proskill_error code) {
    std::exception_ptr first;
    std::swap(first, thrown);
    if (first) std::rethrow_exception(first);
    check(code);
  }

  std::deque<Action> actions; /* the executor refers to them */
  Observer observer;
  std::exception_ptr thrown;
  std::unique_ptr<proskill_executor, Free> executor; /* the last member: it ends first */
};

} // namespace proskill

#endif
