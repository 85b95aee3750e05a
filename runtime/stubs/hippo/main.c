// Starts the engine. This file is yours.
#include "hippo_host.h"

#include <hippo.h>

int main(void) {
  if (!hippo_host_open()) return 1;
  engine_run();
  return 0;
}
