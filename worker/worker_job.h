#pragma once

#include "analysis/program/program.h"
#include "rpc/rpc.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The task of the process that verifies for the language server.
namespace proskill::worker {

/// Limits of a verification; properties not decided by then are inconclusive.
struct Budget {
  double seconds = 60;
  std::uint64_t megabytes = 2048;
  std::optional<std::uint64_t> classes;
};

struct WorkerText {
  std::filesystem::path path;
  std::string text;
};

struct WorkerJob {
  std::vector<WorkerText> texts;  ///< the root first; no other files are read
  std::vector<std::string> names; ///< of properties; empty: all
  bool durations = false;         ///< measure how long skills take instead of verifying
  std::string mainSkill;          ///< empty: the skill that no other skill calls
  Budget budget;
};

/// All texts of a program, with the editor's unsaved changes.
[[nodiscard]] WorkerJob jobFor(const analysis::Program& program);

/// A line of JSON, followed by the bytes of the texts, which may be invalid in JSON.
[[nodiscard]] std::string encode(const WorkerJob& job, int parentId);

/// The first line of an encoded job.
struct JobHeader {
  WorkerJob job; ///< its texts are empty
  int parentId = 0;
  std::vector<std::size_t> lengths; ///< of the texts, in bytes
};
/// Nothing if the line is not such a header.
[[nodiscard]] std::optional<JobHeader> decodeHeader(std::string_view line);

} // namespace proskill::worker
