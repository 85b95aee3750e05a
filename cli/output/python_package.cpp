#include "cli/output/python_package.h"

#include <filesystem>

namespace proskill::cli {

namespace {

/// Where this program lies.
std::filesystem::path folderOfProgram() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

} // namespace

std::vector<std::string> pythonPackage(const std::string& part) {
  std::error_code error;
  const auto folder = folderOfProgram();
  for (const char* place : {"../lib/python3/dist-packages", "../../python"}) {
    const auto found = (folder / place / "proskill" / part).lexically_normal();
    if (std::filesystem::exists(found / "__main__.py", error)) return {found.string()};
  }
  return {"-m", "proskill." + part};
}

std::string ddsLibrary() {
  std::error_code error;
  const auto folder = folderOfProgram();
  for (const char* place : {"../lib/proskill", "../lib"}) {
    const auto found = (folder / place / "libproskill_dds.so").lexically_normal();
    if (std::filesystem::exists(found, error)) return found.string();
  }
  return "";
}

} // namespace proskill::cli
