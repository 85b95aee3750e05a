/* Implements the actions of a ProSkill program as functions in a shared library:
   docs/platforms.md.

   `proskill run` loads the library in a process of its own, and looks up one function for each
   basic skill. For the skill `fly` this is one of

     const char *skill_fly(proskill_run run, const proskill_value *arguments, size_t count);
     void begin_fly(proskill_run run, const proskill_value *arguments, size_t count);

   `skill_fly` blocks: it has a thread of its own, and returns the name of a result. `begin_fly`
   returns at once; proskill_finish ends the run later. The platform file may name other functions.

   All functions of this header are thread-safe. Calls with the number of a run that has ended have
   no effect. Requires C99 or C++11. SPDX-License-Identifier: MIT */
#ifndef PROSKILL_PLATFORM_H
#define PROSKILL_PLATFORM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this interface. A library of another version is not loaded. */
#define PROSKILL_ABI 1

/* Exports a function or variable, so that `proskill run` finds it. */
#ifdef __cplusplus
#define PROSKILL_EXPORT extern "C" __attribute__((visibility("default")))
#else
#define PROSKILL_EXPORT __attribute__((visibility("default")))
#endif

/* Number of one start of an action. Numbers are never reused. */
typedef uint64_t proskill_run;

typedef enum proskill_type {
  PROSKILL_NONE, /* no value: an `:input` of the mission */
  PROSKILL_INTEGER,
  PROSKILL_FLOAT,
  PROSKILL_BOOLEAN,
  PROSKILL_STRING /* also a value of a state variable */
} proskill_type;

/* An argument of `:action`. It is valid until the function that receives it returns. */
typedef struct proskill_value {
  proskill_type type;
  int64_t integer;    /* of an integer or a boolean (0 or 1) */
  double number;      /* of a float or an integer */
  const char* string; /* of a string; "" for any other type */
} proskill_value;

/* The result of a function that has stopped because it was asked to. */
#define PROSKILL_STOPPED ((const char*)0)

/* Functions that `proskill run` provides. Call them through the functions below. */
typedef struct proskill_host {
  uint32_t abi;
  uint32_t size; /* of this struct; later versions may add functions */
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

/* Describes the library. `proskill run` looks it up first. */
typedef struct proskill_library {
  uint32_t abi;
  uint32_t reserved;
  const proskill_host* host; /* set when the library is loaded */
} proskill_library;

/* Write `PROSKILL_LIBRARY;` once in a library, at the top level of one of its files. */
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

/* A library may define these two functions:

     const char *proskill_open(void);   called before the run; returns an error message, or NULL
     void proskill_close(void);         called after the run, when all actions have ended; has to
   end the library's threads */

/* --- For actions */

/* Whether the action is asked to stop: its skill was interrupted, a guard failed, or the run ends.
 */
static inline bool proskill_stop_requested(proskill_run run) {
  return proskill_this_library.host->stop_requested(run);
}

/* Waits until this many seconds of the run's clock have passed, or the action is asked to stop. In
   the latter case it returns true. */
static inline bool proskill_wait(proskill_run run, double seconds) {
  return proskill_this_library.host->wait(run, seconds);
}

/* File descriptor for poll and select, which becomes readable when the action is asked to stop. -1
   if the run has ended. Do not close it. */
static inline int proskill_stop_descriptor(proskill_run run) {
  return proskill_this_library.host->stop_descriptor(run);
}

/* Registers a function that is called once when the action is asked to stop, or at once if it
   already was. The function must return quickly: the run cannot end while it is being called.
   `data` must stay valid until proskill_finish. */
static inline void proskill_on_stop(proskill_run run, void (*call)(proskill_run run, void* data),
                                    void* data) {
  proskill_this_library.host->on_stop(run, call, data);
}

/* Ends a run that begin_… has started, with one of its results or PROSKILL_STOPPED. */
static inline void proskill_finish(proskill_run run, const char* result) {
  proskill_this_library.host->finish(run, result);
}

/* Ends a run with an error instead of a result. */
static inline void proskill_fail(proskill_run run, const char* why) {
  proskill_this_library.host->fail(run, why);
}

/* The skill of a run, for functions that perform several skills; "" if the run has ended. The
   string is valid until the end of the process. */
static inline const char* proskill_skill(proskill_run run) {
  return proskill_this_library.host->skill(run);
}

/* --- For any thread, at any time */

/* Reports an event of the program. */
static inline void proskill_report(const char* event) { proskill_this_library.host->report(event); }

/* Interrupts a skill. */
static inline void proskill_interrupt(const char* skill) {
  proskill_this_library.host->interrupt(skill);
}

/* Writes a line to the recording. */
static inline void proskill_log(const char* text) { proskill_this_library.host->log(text); }

/* Speed of the run's clock, relative to real time. */
static inline double proskill_speed(void) { return proskill_this_library.host->speed(); }

#ifdef __cplusplus
}
#endif

#endif
