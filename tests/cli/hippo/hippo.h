/* A substitute for Hippo's public header: what docs say of it. */
#ifndef HIPPO_H
#define HIPPO_H

void engine_run(void);

#endif
