#pragma once

#include "analysis/program/file_system.h"

#include <map>
#include <string>

namespace proskill::test {

/// Files in memory.
class MemoryFiles : public analysis::FileSystem {
public:
  explicit MemoryFiles(std::map<std::string, std::string> files = {}) : files(std::move(files)) {}

  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const override {
    auto found = files.find(canonical(path).generic_string());
    if (found == files.end()) return std::unexpected("no such file");
    return found->second;
  }
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override {
    return path.lexically_normal();
  }

private:
  std::map<std::string, std::string> files;
};

} // namespace proskill::test
