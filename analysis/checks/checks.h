#pragma once

#include "analysis/names/names.h"

/// The checks, one file each (`check_NAME.cpp`). docs/howto/add-a-check.md explains how to add one.
/// The checks of the first group also record each name that they read in the index.
namespace proskill::analysis {

void checkConstants(Context& context);
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
