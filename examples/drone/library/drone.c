/* A drone that flies in numbers, in C: performs the actions of drone.proskill and reports its sensors.

       make -C examples/drone/library
       proskill run --platform examples/drone/library/platform.json --clock 10x examples/drone/drone.proskill
 */

#include <math.h>
#include <proskill/platform.h>
#include <pthread.h>
#include <stdio.h>

PROSKILL_LIBRARY;

#define SPEED 1.5 /* m/s */
#define STEP 0.1  /* s */

typedef struct {
  double x, y, z;
} point;

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static point position;

/* Returns whether it is to stop; then it stays where it is. */
static bool fly_to(proskill_run run, point target) {
  for (;;) {
    pthread_mutex_lock(&mutex);
    const double dx = target.x - position.x, dy = target.y - position.y, dz = target.z - position.z;
    const double left = sqrt(dx * dx + dy * dy + dz * dz);
    const double part = left > SPEED * STEP ? SPEED * STEP / left : 1;
    position.x += part * dx;
    position.y += part * dy;
    position.z += part * dz;
    pthread_mutex_unlock(&mutex);
    if (left == 0) return false;
    if (proskill_wait(run, STEP)) return true;
  }
}

static point here(void) {
  pthread_mutex_lock(&mutex);
  const point at = position;
  pthread_mutex_unlock(&mutex);
  return at;
}

#define ACTION(skill) \
  PROSKILL_EXPORT const char *skill(proskill_run run, const proskill_value *arguments, size_t count)

ACTION(skill_start_drone) {
  (void)arguments, (void)count;
  if (proskill_wait(run, 1.5)) return PROSKILL_STOPPED;
  proskill_report("localization_status_to_valid");
  return "ready";
}

ACTION(skill_takeoff) {
  (void)count;
  point target = here();
  target.z = arguments[0].number;
  if (fly_to(run, target)) return PROSKILL_STOPPED;
  proskill_report("flight_status_to_in_air");
  return "at_altitude";
}

ACTION(skill_goto_waypoint) {
  (void)count;
  const point target = {arguments[0].number, arguments[1].number, arguments[2].number};
  if (fly_to(run, target)) return PROSKILL_STOPPED;
  char text[100];
  snprintf(text, sizeof text, "at (%g, %g, %g)", target.x, target.y, target.z);
  proskill_log(text);
  return proskill_wait(run, 22) ? PROSKILL_STOPPED : "arrived"; /* the camera wants time */
}

ACTION(skill_landing) {
  (void)arguments, (void)count;
  point target = here();
  target.z = 0;
  if (fly_to(run, target) || proskill_wait(run, 3)) return PROSKILL_STOPPED;
  proskill_report("flight_status_to_on_ground");
  return "landed";
}

ACTION(skill_shutdown_drone) {
  (void)arguments, (void)count;
  return proskill_wait(run, 1) ? PROSKILL_STOPPED : "stopped";
}

/* Without a thread of its own: the camera sees nothing until it is asked to stop. */
static void close_camera(proskill_run run, void *data) {
  (void)data;
  proskill_finish(run, PROSKILL_STOPPED);
}

PROSKILL_EXPORT void begin_camera_survey(proskill_run run, const proskill_value *arguments, size_t count) {
  (void)arguments, (void)count;
  proskill_on_stop(run, close_camera, NULL);
}
