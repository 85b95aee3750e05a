#pragma once

#include "report/text/source_place.h"

#include <nlohmann/json.hpp>

#include <iosfwd>

/// What every SARIF 2.1.0 log of ours shares, whatever its results are about.
namespace proskill::report {

/// An `artifactLocation`: the file as a URI, relative where its path is.
[[nodiscard]] nlohmann::ordered_json sarifFile(const SourcePlaces& places, syntax::FileId file);
/// A `region`, whose columns are characters, from 1.
[[nodiscard]] nlohmann::ordered_json sarifRegion(SourcePlaces& places, analysis::Location location);
/// A `location` that holds a place.
[[nodiscard]] nlohmann::ordered_json sarifLocation(SourcePlaces& places,
                                                   analysis::Location location);

/// The whole log of one run. Bytes that are not UTF-8 become U+FFFD.
void writeSarifLog(std::ostream& out, nlohmann::ordered_json rules, nlohmann::ordered_json results);

} // namespace proskill::report
