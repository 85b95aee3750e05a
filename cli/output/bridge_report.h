#pragma once

#include "bridge/text/place.h"

namespace proskill::cli {

/// Prints errors of other languages to standard error, one per line. \return kFailed
int reportErrors(const bridge::Errors& errors);

/// Prints to standard error what was approximated or omitted, one per line.
void reportNotes(const std::vector<bridge::Note>& notes);

} // namespace proskill::cli
