#pragma once

#include "analysis/flow/result/report.h"

/// The checks, one file each (`check_NAME.cpp`), in the order in which they run. An earlier check
/// reports causes that later checks then do not report again.
namespace proskill::analysis::flow {

void checkMoves(Report& report);
void checkPreconditions(Report& report);
void checkEventGuards(Report& report);
void checkStatuses(Report& report);
void checkWaits(Report& report);
void checkTests(Report& report);
void checkUnreachable(Report& report);
void checkInvariants(Report& report);
void checkPostconditions(Report& report);
void checkInterrupts(Report& report);
void checkUnused(Report& report);
void checkValues(Report& report);
void checkResults(Report& report);
void checkBranches(Report& report);
void checkResourceOrder(Report& report);
void checkSharedSkills(Report& report);
void checkProgress(Report& report);
void checkRounds(Report& report);
void checkDurations(Report& report);
void checkTicks(Report& report);
void checkStyle(Report& report);

} // namespace proskill::analysis::flow
