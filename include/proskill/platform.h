/* The actions of a ProSkill program as functions in a shared library: docs/platforms.md.

   `proskill run` loads the library in a process of its own, and looks in it for a function for each
   basic skill. For the skill `fly` this is one of

     const char *skill_fly(proskill_run run, const proskill_value *arguments, size_t count);
     void begin_fly(proskill_run run, const proskill_value *arguments, size_t count);

   `skill_fly` blocks: it has a thread of its own, and returns the name of a result. `begin_fly`
   returns soon, and proskill_finish ends the run later. Other functions may be named in the
   platform file.

   Every function of this header may be called from any thread, with any number of a run: what has
   ended is not touched. C99 and C++11 or later; SPDX-License-Identifier: MIT */
#ifndef PROSKILL_PLATFORM_H
#define PROSKILL_PLATFORM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of what follows. A library of another version is not loaded. */
#define PROSKILL_ABI 1

/* Before each function and variable that `proskill run` looks for. */
#ifdef __cplusplus
#define PROSKILL_EXPORT extern "C" __attribute__((visibility("default")))
#else
#define PROSKILL_EXPORT __attribute__((visibility("default")))
#endif

/* One start of an action. No other has its number. */
typedef uint64_t proskill_run;

typedef enum proskill_type {
  PROSKILL_NONE, /* it has no value: of a mission with `:input` */
  PROSKILL_INTEGER,
  PROSKILL_FLOAT,
  PROSKILL_BOOLEAN,
  PROSKILL_STRING /* also a value of a state variable */
} proskill_type;

/* An argument of `:action`. It lives until the function that gets it returns. */
typedef struct proskill_value {
  proskill_type type;
  int64_t integer;    /* an integer; a boolean: 0 or 1 */
  double number;      /* a float or an integer */
  const char* string; /* a string; of any other type: "" */
} proskill_value;

/* What a function returns that has stopped because it was asked to. */
#define PROSKILL_STOPPED ((const char*)0)

/* What `proskill run` offers. It is called by the functions below. */
typedef struct proskill_host {
  uint32_t abi;
  uint32_t size; /* of this struct: later versions may add functions */
  bool (*stop_requested)(proskill_run run);
  bool (*wait)(proskill_run run, double seconds);
  int (*stop_descriptor)(proskill_run run);
  void (*on_stop)(proskill_run run, void (*call)(proskill_run run, void* data), void* data);
  void (*finish)(proskill_run run, const char* result);
  void (*fail)(proskill_run run, const char* why);
  const char* (*skill)(proskill_run run);
  void (*report)(const char* event);
  void (*interrupt)(const char* skill);
  void (*log)(const char* text);
  double (*speed)(void);
} proskill_host;

/* What `proskill run` looks for first. */
typedef struct proskill_library {
  uint32_t abi;
  uint32_t reserved;
  const proskill_host* host; /* set when the library was loaded */
} proskill_library;

/* To be written once in a library, at the top level of one of its files: PROSKILL_LIBRARY; */
#ifdef __cplusplus
#define PROSKILL_LIBRARY                                                                           \
  extern "C" {                                                                                     \
  __attribute__((visibility("default")))                                                           \
  proskill_library proskill_this_library = {PROSKILL_ABI, 0, nullptr};                             \
  }                                                                                                \
  struct proskill_library
#else
#define PROSKILL_LIBRARY                                                                           \
  PROSKILL_EXPORT proskill_library proskill_this_library = {PROSKILL_ABI, 0, NULL};                \
  struct proskill_library
#endif
extern __attribute__((visibility("default"))) proskill_library proskill_this_library;

/* A library may have these two:

     const char *proskill_open(void);   before the run begins; it returns why it cannot, or NULL
     void proskill_close(void);         after the run, when every action has ended; it ends the
   library's threads */

/* --- Within an action */

/* Whether it is asked to stop: the skill was interrupted, or a guard failed, or the run ends. */
static inline bool proskill_stop_requested(proskill_run run) {
  return proskill_this_library.host->stop_requested(run);
}

/* Waits so many seconds of the run's clock, or until the action is asked to stop: then it returns
 * true. */
static inline bool proskill_wait(proskill_run run, double seconds) {
  return proskill_this_library.host->wait(run, seconds);
}

/* For poll and select: it can be read from when the action is asked to stop. It is not to be
   closed, and is -1 for a run that has ended. */
static inline int proskill_stop_descriptor(proskill_run run) {
  return proskill_this_library.host->stop_descriptor(run);
}

/* Has a function called, once, when the action is asked to stop; at once where it has been. It
   returns soon: until then, the end of the run waits in other threads. So what `data` points to
   lives at least until proskill_finish. */
static inline void proskill_on_stop(proskill_run run, void (*call)(proskill_run run, void* data),
                                    void* data) {
  proskill_this_library.host->on_stop(run, call, data);
}

/* Ends a run that begin_… has begun: by one of its results, or PROSKILL_STOPPED. */
static inline void proskill_finish(proskill_run run, const char* result) {
  proskill_this_library.host->finish(run, result);
}

/* Ends a run without a result, as an exception does. */
static inline void proskill_fail(proskill_run run, const char* why) {
  proskill_this_library.host->fail(run, why);
}

/* The skill that a run is of, for a function of several skills; "" where the run has ended. It
   lives until the end of the program. */
static inline const char* proskill_skill(proskill_run run) {
  return proskill_this_library.host->skill(run);
}

/* --- At any time */

/* An event of the program has happened. */
static inline void proskill_report(const char* event) { proskill_this_library.host->report(event); }

/* Somebody wants a skill to end. */
static inline void proskill_interrupt(const char* skill) {
  proskill_this_library.host->interrupt(skill);
}

/* A line for the recording. */
static inline void proskill_log(const char* text) { proskill_this_library.host->log(text); }

/* How many times as fast as real time the run's clock goes. */
static inline double proskill_speed(void) { return proskill_this_library.host->speed(); }

#ifdef __cplusplus
}
#endif

#endif
