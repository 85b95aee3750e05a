#pragma once

#include "tests/support/memory_files.h"

namespace proskill::test {

/// Files in memory, with links between them.
class LinkedFiles : public MemoryFiles {
public:
  using Links = std::map<std::string, std::string>; ///< from each link to its target

  LinkedFiles(std::map<std::string, std::string> files, Links links)
      : MemoryFiles(std::move(files)), links(std::move(links)) {}

  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override {
    const auto link = links.find(path.lexically_normal().generic_string());
    return link == links.end() ? path.lexically_normal() : std::filesystem::path(link->second);
  }

private:
  Links links;
};

} // namespace proskill::test
