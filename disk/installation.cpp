#include "disk/installation.h"

#include <cstdlib>
#include <dlfcn.h>
#include <sstream>
#include <string_view>
#include <unistd.h>

namespace proskill::disk {

namespace fs = std::filesystem;

namespace {

fs::path thisProgram() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

/// The shared library with this code, or this program.
fs::path thisLibrary() {
  Dl_info info{};
  // The name of a program may be relative to a folder that it has left.
  if (::dladdr(reinterpret_cast<const void*>(&thisProgram), &info) == 0) return thisProgram();
  std::error_code error;
  auto found = fs::canonical(info.dli_fname, error);
  return error ? thisProgram() : found;
}

bool isProgram(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

} // namespace

fs::path folderOfProgram() { return thisProgram().parent_path(); }

fs::path proskillOfLibrary() {
  const auto folder = thisLibrary().parent_path();
  for (const char* place : {"", "../bin", "../../bin"})
    if (auto found = (folder / place / "proskill").lexically_normal(); isProgram(found))
      return found;
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string each; std::getline(folders, each, ':');)
    if (auto found = fs::path(each) / "proskill"; found.is_absolute() && isProgram(found))
      return found;
  return {};
}

fs::path viewLibrary() {
  const auto folder = thisLibrary().parent_path();
  std::error_code error;
  for (const char* place : {"proskill", "", "../lib"})
    if (auto found = (folder / place / "libproskill_view.so").lexically_normal();
        fs::exists(found, error))
      return found;
  return {};
}

std::vector<std::string> pythonPackage(const fs::path& folder, const std::string& part) {
  std::error_code error;
  for (const char* place : {"../lib/python3/dist-packages", "../../python"}) {
    const auto found = (folder / place / "proskill" / part).lexically_normal();
    if (fs::exists(found / "__main__.py", error)) return {found.string()};
  }
  return {"-m", "proskill." + part};
}

std::string ddsLibrary(const fs::path& folder) {
  std::error_code error;
  for (const char* place : {"../lib/proskill", "../lib"}) {
    const auto found = (folder / place / "libproskill_dds.so").lexically_normal();
    if (fs::exists(found, error)) return found.string();
  }
  return "";
}

} // namespace proskill::disk
