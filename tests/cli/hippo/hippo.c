/* A substitute for Hippo's engine: calls the functions of docs/tour/dock.proskill as its transitions do, and prints
   what they return. */
#include "hippo.h"

#include "hippo_app_functions.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

int drive_onto_dock_action(skill_record_c skill);
int charge_action(skill_record_c skill);
bool charge_begin(void);
bool charge_interrupt_action(void);
void c_pushed_away(void);

double charging_time = 0;
static const skill_record_c none;

static void *charges(void *result) {
  *(int *)result = charge_action(none);
  return NULL;
}

void engine_run(void) {
  printf("drive %d\n", drive_onto_dock_action(none));
  c_pushed_away();
  printf("pushed away\n");

  charge_begin();
  printf("charge %d\n", charge_action(none));

  charging_time = 600;
  charge_begin();
  charge_interrupt_action(); /* before the task's thread runs */
  printf("overtaken %d\n", charge_action(none));

  pthread_t thread;
  int result = -1;
  charge_begin();
  if (pthread_create(&thread, NULL, charges, &result) != 0) abort();
  usleep(50000);
  charge_interrupt_action();
  pthread_join(thread, NULL);
  printf("stopped %d\n", result);

  charge_interrupt_action(); /* too late: not for the next start */
  charging_time = 0;
  charge_begin();
  printf("next %d\n", charge_action(none));
}
