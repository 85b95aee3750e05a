/* Executes docs/tour/dock.proskill in an event loop of its own: it waits for the run, and for events
   that the user types.

       dock_c docs/tour/dock.proskill
       pushed_away
 */

#include <poll.h>
#include <proskill/executor.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

static proskill_executor *executor;

static void drive(proskill_executor *in, proskill_run run, const proskill_value *arguments, size_t count, void *data) {
  (void)count, (void)data;
  printf("the robot drives to the %s\n", arguments[0].string);
  proskill_executor_finish_after(in, run, 3, "docked");
}

static void charge(proskill_executor *in, proskill_run run, const proskill_value *arguments, size_t count, void *data) {
  (void)arguments, (void)count, (void)data;
  proskill_executor_finish_after(in, run, 15, "full");
}

/* Both actions stop at once. */
static void stop(proskill_executor *in, proskill_run run, void *data) {
  (void)data;
  proskill_executor_finish(in, run, PROSKILL_STOPPED);
}

static void show(proskill_executor *in, const proskill_entry *entry, void *data) {
  (void)in, (void)data;
  printf("%9.3f s  %s%s%s %s\n", entry->time, entry->is_fault ? "fault: " : "", entry->subject,
         *entry->subject ? ":" : "", entry->text);
}

static void on_signal(int number) {
  (void)number;
  proskill_executor_stop(executor);
}

/* Reports the event that the user has typed. \return whether there may be more */
static int read_event(void) {
  char line[100];
  if (!fgets(line, sizeof line, stdin)) return 0;
  line[strcspn(line, "\n")] = '\0';
  if (proskill_executor_report(executor, line) != PROSKILL_OK)
    printf("not reported: %s\n", proskill_error_text());
  return 1;
}

/* Waits for the run and the user, until the run ends. */
static proskill_error event_loop(void) {
  struct pollfd watched[] = {{proskill_executor_descriptor(executor), POLLIN, 0}, {0, POLLIN, 0}};
  proskill_error error = proskill_executor_start(executor);
  while (error == PROSKILL_OK) {
    error = proskill_executor_proceed(executor);
    if (error != PROSKILL_OK || proskill_executor_phase(executor) == PROSKILL_ENDED) break;
    const double seconds = proskill_executor_timeout(executor);
    poll(watched, 2, seconds < 0 ? -1 : (int)(seconds * 1000) + (seconds > 0));
    if (watched[1].revents && !read_event()) watched[1].fd = -1;
  }
  return error;
}

static proskill_error run(const char *file) {
  proskill_options options = PROSKILL_OPTIONS;
  options.speed = 10;
  proskill_program *program = NULL;
  proskill_error error = proskill_program_load(file, &program);
  if (error == PROSKILL_OK) error = proskill_executor_new(program, &options, &executor);
  if (error == PROSKILL_OK) error = proskill_executor_perform(executor, "drive_onto_dock", drive, stop, NULL);
  if (error == PROSKILL_OK) error = proskill_executor_perform(executor, "charge", charge, stop, NULL);
  if (error == PROSKILL_OK) error = proskill_executor_observe(executor, show, NULL);
  if (error == PROSKILL_OK) signal(SIGINT, on_signal);
  if (error == PROSKILL_OK) error = event_loop();
  proskill_program_free(program);
  return error;
}

int main(int count, char **arguments) {
  setvbuf(stdout, NULL, _IONBF, 0);
  setvbuf(stdin, NULL, _IONBF, 0); /* poll knows nothing of lines that C has already read */
  if (count != 2 || run(arguments[1]) != PROSKILL_OK) {
    fprintf(stderr, "%s\n", count == 2 ? proskill_error_text() : "usage: dock_c PROGRAM");
    return 2;
  }
  const char *place = "";
  proskill_executor_value(executor, "place", &place);
  printf("the mission ends with %s; the robot is on the %s\n", proskill_executor_outcome(executor), place);
  const int exit_code = strcmp(proskill_executor_outcome(executor), "success") != 0;
  signal(SIGINT, SIG_DFL);
  proskill_executor_free(executor);
  return exit_code;
}
