#pragma once

#include <string>
#include <vector>

namespace proskill::test {

struct Example {
  std::string name; ///< from the examples' folder on
  std::string text;
};

/// Every program in examples/, in the order of its name.
[[nodiscard]] std::vector<Example> examples();

/// Texts that are wrong in one way each: deep, long, binary, half of something.
struct Broken {
  std::string name;
  std::string text;
};
[[nodiscard]] std::vector<Broken> brokenTexts();

[[nodiscard]] std::string repeated(const std::string& part, std::size_t times);
/// Any bytes, the same ones for the same seed.
[[nodiscard]] std::string randomBytes(std::uint64_t seed, std::size_t count);
/// The characters and words that mean something to the parser, in any order.
[[nodiscard]] std::string randomWords(std::uint64_t seed, std::size_t count);

} // namespace proskill::test
