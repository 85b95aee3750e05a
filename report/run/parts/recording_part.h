#pragma once

#include "report/run/mcap.h"

#include <expected>
#include <optional>
#include <string>

namespace proskill::report {

/// A part of a long recording.
struct PartOfRun {
  std::optional<double> from; ///< seconds since the start of the run; nullopt: the part is the last
  std::uint64_t bytes = std::uint64_t{16} << 20; ///< of the recording, about
};

/// A part of a recording as a trace in JSON. Unless it is the whole run, its description and its
/// member `part` (`begin`, `end`, `length`, and `run`, the description of the whole) say which part
/// it is.
struct TraceOfPart {
  std::string text;
  double begin = 0; ///< in seconds since the start of the run
  double end = 0;
  double length = 0; ///< of the recorded run
  bool isWhole = true;
};

/// Whether of a file only a part is shown: of each MCAP file, and of a trace with a step in each
/// line that is larger than 256 MiB, or of which a part from a date on is wanted.
[[nodiscard]] bool isShownInParts(const mcap::File& file, const PartOfRun& part);

/// The error is a message. \pre it is shown in parts
[[nodiscard]] std::expected<TraceOfPart, std::string> traceOfPart(const mcap::File& recording,
                                                                  const PartOfRun& part);

/// Why a file is not shown, which cannot be read as a whole for this reason: with an advice, if it
/// is a trace that is too large.
[[nodiscard]] std::string whyNotShown(const mcap::File& file, const std::string& reason);

} // namespace proskill::report
