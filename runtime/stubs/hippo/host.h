/* Performs actions that are written for proskill/platform.h when Hippo asks for them.
   SPDX-License-Identifier: MIT */
#ifndef HIPPO_HOST_H
#define HIPPO_HOST_H

#include <proskill/platform.h>

/* Performs an action: as `skill_fly` of proskill/platform.h. */
typedef const char* (*hippo_action)(proskill_run run, const proskill_value* arguments,
                                    size_t count);

/* In hippo_glue.c: the skills and the events of the program, by number. */
extern const char* const hippo_skills[];
extern const size_t hippo_skill_count;
extern const char* const hippo_events[];
extern const size_t hippo_event_count;

/* Before engine_run. Returns false if memory or locks are missing. */
bool hippo_host_open(void);

/* The transition that starts a task: from now on a stop is for this start. */
void hippo_begin(size_t skill);
/* The task's thread: performs the action. Returns its result; NULL: it has stopped or failed. */
const char* hippo_perform(size_t skill, hippo_action action, const proskill_value* arguments,
                          size_t count);
/* Asks an action to stop, also one that has begun and whose thread does not run yet. */
void hippo_stop(size_t skill);
/* The thread of an event: returns when the event has occurred. */
void hippo_await_event(size_t event);

#endif
