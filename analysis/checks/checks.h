#pragma once

#include "analysis/names/names.h"

/// The checks, one file each (`check_NAME.cpp`); docs/howto/add-a-check.md says how to add one.
/// Those of the first group also note every name that they meet for the index.
namespace proskill::analysis {

void checkStateVariables(Context& context);
void checkEvents(Context& context);
void checkResources(Context& context);
void checkSkills(Context& context);
void checkBodies(Context& context);
void checkControl(Context& context);
void checkProperties(Context& context);

void checkDuplicates(Context& context);
void checkFields(Context& context);
void checkIntervals(Context& context);
void checkRecursion(Context& context);
void checkParallel(Context& context);
void checkStart(Context& context);
void checkReserved(Context& context);

} // namespace proskill::analysis
