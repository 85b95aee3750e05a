#include "actions.h"

#include <string.h>

extern double charging_time;

drive_onto_dock_result perform_drive_onto_dock(proskill_run run, const char *argument1) {
  (void)run;
  report_event(EVENT_PUSHED_AWAY);
  return strcmp(argument1, "dock") == 0 ? DRIVE_ONTO_DOCK_DOCKED : DRIVE_ONTO_DOCK_MISSED;
}

charge_result perform_charge(proskill_run run) {
  return proskill_wait(run, charging_time) ? CHARGE_WAS_STOPPED : CHARGE_FULL;
}
