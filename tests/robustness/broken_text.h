#pragma once

#include <string>
#include <vector>

namespace proskill::test {

struct Example {
  std::string name; ///< relative to the examples' folder
  std::string text;
};

/// Every program in examples/, by name.
[[nodiscard]] std::vector<Example> examples();

/// Texts with one problem each: deep, long, binary, truncated.
struct Broken {
  std::string name;
  std::string text;
};
[[nodiscard]] std::vector<Broken> brokenTexts();

[[nodiscard]] std::string repeated(const std::string& part, std::size_t times);
/// Random bytes from a seed.
[[nodiscard]] std::string randomBytes(std::uint64_t seed, std::size_t count);
/// Characters and words that the parser knows, in random order.
[[nodiscard]] std::string randomWords(std::uint64_t seed, std::size_t count);

} // namespace proskill::test
