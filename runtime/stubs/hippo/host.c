/* The functions of proskill/platform.h, on threads and locks of POSIX.
   SPDX-License-Identifier: MIT */
#define _GNU_SOURCE
#include "hippo_host.h"

#include <errno.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/eventfd.h>
#include <time.h>
#include <unistd.h>

/* The current start of a skill's action. */
typedef struct {
  proskill_run run; /* 0: none */
  bool stop;
  int descriptor; /* readable once it is to stop; -1: nobody has asked for it */
  void (*call)(proskill_run run, void *data);
  void *data;
} hippo_slot;

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed;
static hippo_slot *slots;
static unsigned *occurred; /* by event: how often, and not taken yet */
static proskill_run last_run;

/* The slot of a run, while the lock is held; NULL: it has ended. */
static hippo_slot *slot_of(proskill_run run) {
  for (size_t i = 0; run != 0 && i < hippo_skill_count; ++i)
    if (slots[i].run == run) return &slots[i];
  return NULL;
}

void hippo_begin(size_t skill) {
  pthread_mutex_lock(&lock);
  hippo_slot *slot = &slots[skill];
  slot->run = ++last_run;
  slot->stop = false;
  pthread_mutex_unlock(&lock);
}

const char *hippo_perform(size_t skill, hippo_action action, const proskill_value *arguments,
                          size_t count) {
  pthread_mutex_lock(&lock);
  const proskill_run run = slots[skill].run;
  pthread_mutex_unlock(&lock);
  const char *result = action(run, arguments, count);
  pthread_mutex_lock(&lock);
  hippo_slot *slot = &slots[skill];
  slot->run = 0;
  if (slot->descriptor >= 0) close(slot->descriptor);
  slot->descriptor = -1;
  slot->call = NULL;
  pthread_mutex_unlock(&lock);
  return result;
}

void hippo_stop(size_t skill) {
  pthread_mutex_lock(&lock);
  hippo_slot *slot = &slots[skill];
  if (slot->run != 0 && !slot->stop) {
    slot->stop = true;
    if (slot->descriptor >= 0) eventfd_write(slot->descriptor, 1);
    if (slot->call) slot->call(slot->run, slot->data);
    slot->call = NULL;
    pthread_cond_broadcast(&changed);
  }
  pthread_mutex_unlock(&lock);
}

void hippo_await_event(size_t event) {
  pthread_mutex_lock(&lock);
  while (occurred[event] == 0) pthread_cond_wait(&changed, &lock);
  --occurred[event];
  pthread_mutex_unlock(&lock);
}

static bool stop_requested(proskill_run run) {
  pthread_mutex_lock(&lock);
  const hippo_slot *slot = slot_of(run);
  const bool stop = !slot || slot->stop;
  pthread_mutex_unlock(&lock);
  return stop;
}

static bool wait_for(proskill_run run, double seconds) {
  struct timespec end;
  clock_gettime(CLOCK_MONOTONIC, &end);
  const double whole = seconds > 0 ? seconds : 0;
  end.tv_sec += (time_t)whole;
  end.tv_nsec += (long)((whole - (double)(time_t)whole) * 1e9);
  if (end.tv_nsec >= 1000000000L) {
    end.tv_nsec -= 1000000000L;
    ++end.tv_sec;
  }
  pthread_mutex_lock(&lock);
  const hippo_slot *slot = slot_of(run);
  int late = 0;
  while (slot && slot->run == run && !slot->stop && late != ETIMEDOUT)
    late = pthread_cond_timedwait(&changed, &lock, &end);
  const bool stop = !slot || slot->run != run || slot->stop;
  pthread_mutex_unlock(&lock);
  return stop;
}

static int stop_descriptor(proskill_run run) {
  pthread_mutex_lock(&lock);
  hippo_slot *slot = slot_of(run);
  if (slot && slot->descriptor < 0) slot->descriptor = eventfd(slot->stop ? 1 : 0, EFD_CLOEXEC);
  const int descriptor = slot ? slot->descriptor : -1;
  pthread_mutex_unlock(&lock);
  return descriptor;
}

static void on_stop(proskill_run run, void (*call)(proskill_run, void *), void *data) {
  pthread_mutex_lock(&lock);
  hippo_slot *slot = slot_of(run);
  if (slot && slot->stop) {
    call(run, data);
  } else if (slot) {
    slot->call = call;
    slot->data = data;
  }
  pthread_mutex_unlock(&lock);
}

static void say(const char *what, const char *text) {
  fprintf(stderr, "%s%s\n", what, text ? text : "");
}

/* A blocking function returns its result instead. */
static void finish(proskill_run run, const char *result) {
  (void)run;
  say("proskill_finish has no effect with Hippo: ", result);
}

static const char *skill_of(proskill_run run) {
  pthread_mutex_lock(&lock);
  const hippo_slot *slot = slot_of(run);
  const char *name = slot ? hippo_skills[slot - slots] : "";
  pthread_mutex_unlock(&lock);
  return name;
}

static void fail(proskill_run run, const char *why) {
  fprintf(stderr, "%s has failed: %s\n", skill_of(run), why ? why : "");
}

static void occur(const char *name) {
  for (size_t i = 0; i < hippo_event_count; ++i)
    if (strcmp(hippo_events[i], name) == 0) {
      pthread_mutex_lock(&lock);
      ++occurred[i];
      pthread_cond_broadcast(&changed);
      pthread_mutex_unlock(&lock);
      return;
    }
  say("the program does not take this event: ", name);
}

static void interrupt(const char *skill) {
  char name[256];
  snprintf(name, sizeof name, "interrupt %s", skill);
  occur(name);
}

static void log_text(const char *text) { say("", text); }
static double speed(void) { return 1; }

bool hippo_host_open(void) {
  static const proskill_host host = {PROSKILL_ABI, sizeof(proskill_host), stop_requested,
                                     wait_for,     stop_descriptor,       on_stop,
                                     finish,       fail,                  skill_of,
                                     occur,        interrupt,             log_text,
                                     speed};
  pthread_condattr_t monotonic;
  if (pthread_condattr_init(&monotonic) != 0) return false;
  pthread_condattr_setclock(&monotonic, CLOCK_MONOTONIC);
  if (pthread_cond_init(&changed, &monotonic) != 0) return false;
  slots = calloc(hippo_skill_count + 1, sizeof *slots);
  occurred = calloc(hippo_event_count + 1, sizeof *occurred);
  if (!slots || !occurred) return false;
  for (size_t i = 0; i < hippo_skill_count; ++i) slots[i].descriptor = -1;
  proskill_this_library.host = &host;
  return true;
}
