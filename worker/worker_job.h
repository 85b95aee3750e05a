#pragma once

#include "analysis/program/program.h"
#include "rpc/rpc.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What the language server asks of the process that verifies for it.
namespace proskill::worker {

/// How much a verification may take; what is open then is inconclusive.
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
  std::vector<WorkerText> texts;  ///< the root first; nothing else is read
  std::vector<std::string> names; ///< of properties; empty: all
  std::string mainSkill;          ///< empty: the one that no other calls
  Budget budget;
};

/// Everything of a program, as the editor holds it.
[[nodiscard]] WorkerJob jobFor(const analysis::Program& program);

/// A line of JSON and the texts' bytes, whatever they are: JSON alone could not carry all of them.
[[nodiscard]] std::string encode(const WorkerJob& job, int parentId);

/// The first line of what `encode` made.
struct JobHeader {
  WorkerJob job; ///< its texts are empty
  int parentId = 0;
  std::vector<std::size_t> lengths; ///< of the texts, in bytes
};
/// Nothing where the line is no such header.
[[nodiscard]] std::optional<JobHeader> decodeHeader(std::string_view line);

} // namespace proskill::worker
