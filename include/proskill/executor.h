/* Executes a ProSkill program within a program of your own: docs/bridges/embedding.md.

   Your functions perform the actions. The executor takes the steps of the program, in a thread of
   yours: in your event loop (proskill_executor_proceed), or until the end of the run
   (proskill_executor_run).

   Functions that can fail return a code, and proskill_error_text says why. The functions below "For
   any thread" are thread-safe. All others may be called by one thread at a time for each executor;
   within a function that the executor calls, only those that read it. Requires C99 or C++11.
   SPDX-License-Identifier: MIT */
#ifndef PROSKILL_EXECUTOR_H
#define PROSKILL_EXECUTOR_H

#include <proskill/platform.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this interface, which is also that of the library: libproskill.so.1. Later versions of
   the library may add functions, and members at the end of structs. */
#define PROSKILL_EXECUTOR_ABI 1

/* The PROSKILL_EXECUTOR_ABI of the library that is loaded. */
uint32_t proskill_executor_abi(void);

typedef enum proskill_error {
  PROSKILL_OK = 0,
  PROSKILL_UNREADABLE = 1,       /* a file cannot be read */
  PROSKILL_INVALID_PROGRAM = 2,  /* the program has errors */
  PROSKILL_UNKNOWN_NAME = 3,     /* no skill, result, event or variable has this name */
  PROSKILL_MISSING_ACTION = 4,   /* nobody performs the action of a basic skill */
  PROSKILL_WRONG_ORDER = 5,      /* the call is not allowed now */
  PROSKILL_INVALID_ARGUMENT = 6, /* a null pointer, or a number out of range */
  PROSKILL_SYSTEM_ERROR = 7,     /* for example: no memory */
  PROSKILL_INVALID_PLATFORM = 8, /* the platform file has errors, or its platform does not start */
  PROSKILL_UNWRITABLE = 9        /* a file cannot be written */
} proskill_error;

/* Why the last call of this thread failed. Valid until the next call that fails; "" before the
   first one. */
const char* proskill_error_text(void);

/* --- Programs */

typedef struct proskill_program proskill_program;

/* Loads a program and the files that it includes. If it has errors, the text has all of them, each
   in a line `FILE:LINE:COLUMN: error: MESSAGE [CODE]`. */
proskill_error proskill_program_load(const char* file, proskill_program** program);

/* Executors that were made of it remain valid. */
void proskill_program_free(proskill_program* program);

/* --- Executors */

/* One run of a program. */
typedef struct proskill_executor proskill_executor;

typedef enum proskill_clock {
  PROSKILL_REAL_TIME = 0,
  PROSKILL_SIMULATED_TIME = 1 /* jumps to what comes next */
} proskill_clock;

typedef struct proskill_options {
  size_t size;            /* of this struct */
  proskill_clock clock;   /* the time of the run */
  double speed;           /* of the clock, relative to real time */
  double until;           /* time limit of the run, in seconds; 0: none */
  double grace;           /* time that an action has to stop, in seconds */
  uint64_t seed;          /* decides between steps that are possible at the same time */
  const char* main_skill; /* the mission; NULL: the skill that no other skill calls */
  bool environment;       /* the program's `defenvironment` causes the events, and not you */
  const char* platform;   /* the file of a platform; NULL: the one that the program names */
  bool no_platform;       /* only your functions perform actions, whatever the program names */
} proskill_options;

/* Initial value of options. */
#define PROSKILL_OPTIONS                                                                           \
  { sizeof(proskill_options), PROSKILL_REAL_TIME, 1, 0, 5, 0, NULL, false, NULL, false }

/* Reads the platform file, if there is one.
   \param options NULL: PROSKILL_OPTIONS */
proskill_error proskill_executor_new(const proskill_program* program,
                                     const proskill_options* options, proskill_executor** executor);

/* Stops nothing: an action of yours that still runs is on its own, and a platform's program is
   killed. No thread may use the executor any more. Fails only within a function that the executor
   calls. */
proskill_error proskill_executor_free(proskill_executor* executor);

/* Begins an action and returns soon; proskill_executor_finish ends it, in this function or later,
   in any thread. The arguments are valid until the function returns. */
typedef void (*proskill_begin)(proskill_executor* executor, proskill_run run,
                               const proskill_value* arguments, size_t count, void* data);

/* Asks an action to stop and returns soon: its skill was interrupted, a guard failed, or the run
   ends. The action still has to be finished, usually with PROSKILL_STOPPED. */
typedef void (*proskill_stop)(proskill_executor* executor, proskill_run run, void* data);

/* Says who performs the action of a basic skill, before the start. Without a platform, every basic
   skill needs this; otherwise the platform performs the actions of the others.
   \param stop NULL: the action goes on until it ends by itself */
proskill_error proskill_executor_perform(proskill_executor* executor, const char* skill,
                                         proskill_begin begin, proskill_stop stop, void* data);

typedef enum proskill_entry_kind {
  PROSKILL_STEP = 0,             /* a step of the program */
  PROSKILL_STARTED = 1,          /* an action was begun */
  PROSKILL_ASKED_TO_STOP = 2,    /* an action was asked to stop */
  PROSKILL_INVARIANT_FAILED = 3, /* an invariant was violated; its step is an entry, too */
  PROSKILL_NOTE = 4,             /* a remark without effect on the run */
  PROSKILL_HOLDS = 5,            /* one of the program's properties is true */
  PROSKILL_UNDERSHOOT = 6,       /* it took less time than its interval allows */
  PROSKILL_OVERSHOOT = 7,        /* it takes more time than its interval allows */
  PROSKILL_ALARM = 8,            /* the program forbids what has happened */
  PROSKILL_FAULT = 9,            /* an action does not do what it should */
  PROSKILL_VIOLATED = 10         /* one of the program's properties is false */
} proskill_entry_kind;

/* What has happened in a run. The strings are valid until the observer returns. */
typedef struct proskill_entry {
  size_t size; /* of this struct */
  proskill_entry_kind kind;
  bool is_fault;       /* from PROSKILL_UNDERSHOOT on */
  double time;         /* seconds since the start of the run */
  const char* subject; /* a skill, an event or a property; "": the run */
  const char* text;    /* what has happened: "succeeds with `docked`" */
  const char* file;    /* the place in the program; "" if there is none */
  uint32_t line;       /* from 1; 0 if there is none */
  uint32_t column;
} proskill_entry;

typedef void (*proskill_observer)(proskill_executor* executor, const proskill_entry* entry,
                                  void* data);

/* Has a function called for everything that happens. Before the start. */
proskill_error proskill_executor_observe(proskill_executor* executor, proskill_observer observer,
                                         void* data);

/* Records the run in a file, as `proskill run --record` does: in MCAP if its name ends in `.mcap`,
   or else as a trace in JSON. An earlier file is replaced when the run starts. Before the start. In
   real time no step waits for the disk; the file is complete when the run has ended or the executor
   is freed, and can be read before. */
proskill_error proskill_executor_record(proskill_executor* executor, const char* file);

/* Why the recording has ended before the run, for example because the disk is full; "" if it has
   not. The run goes on, and the observer gets a note. Valid as long as the executor. */
const char* proskill_executor_recording_error(const proskill_executor* executor);

/* In real time, called in the thread of the run when the page has paused it, and when it has
   continued it: what your actions do should pause in between, as the clock of the run does.
   \param held whether the run is paused from now on */
typedef void (*proskill_hold)(proskill_executor* executor, bool held, void* data);

typedef struct proskill_view_options {
  size_t size;        /* of this struct */
  uint16_t port;      /* on the loopback interface; 0: any free port */
  bool no_controls;   /* the page only shows the run */
  bool paused;        /* the run begins paused, until the page continues it */
  proskill_hold hold; /* NULL: the page cannot pause a run in real time */
  void* data;         /* for `hold` */
} proskill_view_options;

/* Initial value of options. */
#define PROSKILL_VIEW_OPTIONS                                                                      \
  { sizeof(proskill_view_options), 0, false, false, NULL, NULL }

/* Serves a page that shows the run while it happens, as `proskill run --view` does, and afterwards
   until the executor is freed. Before the start. Threads of the library serve it; no step waits for
   them. The page can send events and interrupts, and end the run; in simulated time, and with
   `hold`, pause it. Requires libproskill_view.so, which is installed with the library, and
   Graphviz.
   \param options NULL: PROSKILL_VIEW_OPTIONS */
proskill_error proskill_executor_serve_view(proskill_executor* executor,
                                            const proskill_view_options* options);

/* The address of the page, with a token: http://127.0.0.1:PORT/TOKEN/. Whoever knows it may control
   the run. "" if there is no page. Valid as long as the executor. */
const char* proskill_executor_view_address(const proskill_executor* executor);

/* --- The run */

/* Starts the platform, if there is one, and waits until it is ready; then the clock of the run.
   Takes no step. */
proskill_error proskill_executor_start(proskill_executor* executor);

/* Does what is due, and returns without waiting. In simulated time it first moves to what comes
   next, if nothing else is due. */
proskill_error proskill_executor_proceed(proskill_executor* executor);

/* File descriptor for poll and select, which is readable when the run should proceed before its
   timeout. Do not read or close it. */
int proskill_executor_descriptor(const proskill_executor* executor);

/* Seconds until the run should proceed, at most a day; negative: when the descriptor is readable.
 */
double proskill_executor_timeout(proskill_executor* executor);

/* Runs until the end: starts the run unless it has started, and proceeds whenever it should. */
proskill_error proskill_executor_run(proskill_executor* executor);

/* --- The state of the run. Functions that the executor calls may use these, too. */

typedef enum proskill_phase {
  PROSKILL_READY = 0, /* not started */
  PROSKILL_RUNNING = 1,
  PROSKILL_ENDING = 2, /* takes no more steps; running actions are asked to stop */
  PROSKILL_ENDED = 3
} proskill_phase;
proskill_phase proskill_executor_phase(const proskill_executor* executor);

typedef enum proskill_end {
  PROSKILL_NOT_ENDED = 0,
  PROSKILL_MISSION_ENDED = 1, /* the mission has ended, and no action runs */
  PROSKILL_TIME_LIMIT = 2,    /* `until` was reached */
  PROSKILL_ASKED_TO_END = 3,  /* by proskill_executor_stop; all actions have stopped */
  PROSKILL_ABANDONED = 4,     /* likewise, but an action did not stop in time */
  PROSKILL_STUCK = 5,         /* simulated time: nothing can happen any more */
  PROSKILL_NO_TIME = 6,       /* endless steps without time passing */
  PROSKILL_STEP_FAILED = 7,   /* a step cannot be computed, for example a division by zero */
  PROSKILL_PLATFORM_LOST = 8  /* the platform has ended, and an action should have started */
} proskill_end;
proskill_end proskill_executor_end(const proskill_executor* executor);

/* The status of the mission: "success", "failure" or "no_status"; "" before the end of the run, and
   if there is no mission. */
const char* proskill_executor_outcome(const proskill_executor* executor);

/* Seconds since the start of the run, up to the last call of proskill_executor_proceed. */
double proskill_executor_time(const proskill_executor* executor);
uint64_t proskill_executor_steps(const proskill_executor* executor);
/* Number of entries that are faults. */
uint64_t proskill_executor_faults(const proskill_executor* executor);

/* The value of a state variable (`place`), or the status of a skill (`recharge.status`). The string
   is valid until the next call with this executor. */
proskill_error proskill_executor_value(proskill_executor* executor, const char* name,
                                       const char** value);
/* The names of all values. \return NULL if there are not so many */
const char* proskill_executor_name(const proskill_executor* executor, size_t index);

/* --- For any thread. Also for functions that the executor calls. */

/* Ends an action, with one of its results or PROSKILL_STOPPED. A result that its skill does not
   have is an error, and ends the action without a result. Nothing happens if the run of the action
   has ended. */
proskill_error proskill_executor_finish(proskill_executor* executor, proskill_run run,
                                        const char* result);

/* The same after this many seconds of the run's clock, unless the action ends before. In simulated
   time, actions take their time by this function. */
proskill_error proskill_executor_finish_after(proskill_executor* executor, proskill_run run,
                                              double seconds, const char* result);

/* Ends an action with an error instead of a result. */
proskill_error proskill_executor_fail(proskill_executor* executor, proskill_run run,
                                      const char* why);

/* Whether an action is asked to stop. Also true if its run has ended without it, because it did not
   stop in time. */
bool proskill_executor_stop_requested(const proskill_executor* executor, proskill_run run);

/* Reports an event of the program. Nothing happens if the run has ended. */
proskill_error proskill_executor_report(proskill_executor* executor, const char* event);

/* The same after this many seconds of the run's clock. */
proskill_error proskill_executor_report_after(proskill_executor* executor, double seconds,
                                              const char* event);

/* Interrupts a skill. */
proskill_error proskill_executor_interrupt(proskill_executor* executor, const char* skill);

/* Adds a note to the run, for the observer. */
proskill_error proskill_executor_log(proskill_executor* executor, const char* text);

/* Ends the run in order: the program takes no more steps, and running actions are asked to stop and
   get `grace` seconds for it. The second call does not wait for them. May be called by a signal
   handler, and before the start. */
void proskill_executor_stop(proskill_executor* executor);

#ifdef __cplusplus
}
#endif

#endif
