/* A substitute for a header that Hippo's frac generates. */
#ifndef HIPPO_APP_FUNCTIONS_H
#define HIPPO_APP_FUNCTIONS_H

#include <stdbool.h>

struct a0 {
  int caller;
  int status;
  bool inv_active;
  int ArgIndex;
};
typedef struct a0 skill_record_c;

#endif
