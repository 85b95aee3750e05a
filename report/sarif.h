#pragma once

#include "report/ordered_json.h"
#include "report/text/source_place.h"

#include <iosfwd>

/// Shared parts of SARIF 2.1.0 logs.
namespace proskill::report {

/// An `artifactLocation`: the file as a URI, relative if its path is.
[[nodiscard]] nlohmann::ordered_json sarifFile(const SourcePlaces& places, syntax::FileId file);
/// A `region` with columns in characters, counted from 1.
[[nodiscard]] nlohmann::ordered_json sarifRegion(SourcePlaces& places, analysis::Location location);
/// A `location` for a place in the program.
[[nodiscard]] nlohmann::ordered_json sarifLocation(SourcePlaces& places,
                                                   analysis::Location location);

/// The whole log of one run. Bytes that are not UTF-8 become U+FFFD.
void writeSarifLog(std::ostream& out, nlohmann::ordered_json rules, nlohmann::ordered_json results);

} // namespace proskill::report
