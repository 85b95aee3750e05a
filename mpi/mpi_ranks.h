#pragma once

#include "verify/ranks.h"

/// The processes that `mpirun` has started. The caller deletes the result before it ends, which
/// waits for the others. Call this once.
extern "C" proskill::verify::Ranks* proskillMpiRanks();
