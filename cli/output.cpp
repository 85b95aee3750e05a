#include "cli/output.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>
#include <unistd.h>

namespace proskill::cli {
namespace {

std::string failure(std::string_view where) {
  return fmt::format("{} cannot be written: {}", where, std::generic_category().message(errno));
}

/// A full disk may be known only when the buffer is emptied, so that counts too.
bool writeAll(std::FILE* file, std::string_view bytes) {
  return std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
}

} // namespace

std::optional<std::string> writeOutput(const std::filesystem::path& path, std::string_view bytes) {
  if (path.empty() || path == "-")
    return writeAll(stdout, bytes) ? std::nullopt : std::optional(failure("standard output"));
  auto* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return failure(path.string());
  const bool written = writeAll(file, bytes);
  const auto reason = written ? std::string() : failure(path.string());
  if (std::fclose(file) != 0 && written) return failure(path.string());
  return written ? std::nullopt : std::optional(reason);
}

std::optional<std::string> replaceFile(const std::filesystem::path& path, std::string_view bytes) {
  namespace fs = std::filesystem;
  std::error_code error;
  auto target = fs::canonical(path, error);
  if (error) return fmt::format("{} cannot be written: {}", path.string(), error.message());
  auto status = fs::status(target, error);
  std::string name =
      (target.parent_path() / ("." + target.filename().string() + ".XXXXXX")).string();
  int descriptor = mkstemp(name.data());
  if (descriptor < 0) return failure(path.string());
  close(descriptor);
  auto problem = writeOutput(name, bytes);
  if (!problem) fs::permissions(name, status.permissions(), error);
  if (!problem && !error) fs::rename(name, target, error);
  if (!problem && error)
    problem = fmt::format("{} cannot be written: {}", path.string(), error.message());
  if (problem) fs::remove(name, error);
  return problem;
}

} // namespace proskill::cli
