#pragma once

#include "tests/support/run.h"
#include "tests/where.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

/// Imports of the example `patrol`.
namespace proskill::test::imports {

inline constexpr auto kPatrol = PROSKILL_SOURCE_DIR "/examples/patrol/patrol.xml";
inline constexpr auto kLeaves = PROSKILL_SOURCE_DIR "/examples/patrol/leaves.json";

inline Finished command(std::vector<std::string> words) {
  words.insert(words.begin(), PROSKILL_PROGRAM);
  return run(words);
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace proskill::test::imports
