#pragma once

#include "report/ordered_json.h"
#include "report/report_json.h"
#include "verify/verify.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Traces as the debug adapter replays them.
namespace proskill::dap {

/// Lines and columns from 1; the end is after the last character.
struct Place {
  std::filesystem::path path; ///< canonical
  unsigned line = 1;
  unsigned column = 1;
  unsigned endLine = 1;
  unsigned endColumn = 1;
};

struct Step {
  std::string actor;       ///< a skill, a branch, an event, the environment
  std::string description; ///< "succeeds with `at_altitude`"
  std::optional<Place> place;
  std::string date;           ///< in the run, in seconds since the start, exact: "2.5", "1/3"
  std::string delay;          ///< since the step before
  std::string earliest;       ///< over all runs with these steps
  bool afterEarliest = false; ///< `earliest` itself is excluded
  std::optional<std::string> latest; ///< nullopt: no latest date
  bool beforeLatest = false;         ///< `latest` itself is excluded
  std::vector<verify::Change> changes;
  std::vector<std::string> transitions; ///< of the Fiacre model
  std::string why;                      ///< may be empty
  bool relevant = true;                 ///< to what the trace shows
};

struct Trace {
  std::string name;        ///< of the property; empty: a simulation
  std::string description; ///< of the property; may be empty
  std::string verdict;     ///< `violated`; may be empty
  std::string summary;     ///< what the trace shows, as a sentence; may be empty
  std::vector<verify::Change> initial;
  std::vector<Step> steps;
};

/// Reads a trace: saved by `proskill verify`, from a property of its JSON report, or from the
/// language server's `proskill/trace`. The error is a message.
/// \param base directory for its relative paths
[[nodiscard]] std::expected<Trace, std::string> readTrace(const OrderedJson& json,
                                                          const std::filesystem::path& base);

/// When a step may happen: `[2 s, 5 s]`, `]0 s, …[`.
[[nodiscard]] std::string windowOf(const Step& step);

/// A unique spelling for each file.
[[nodiscard]] std::filesystem::path oneSpelling(const std::filesystem::path& path);

} // namespace proskill::dap
