// Prints the benchmark program with this many lines, for benchmarks in other languages.

#include "bench/programs.h"

#include <charconv>
#include <cstdio>
#include <string_view>

int main(int count, char** arguments) {
  std::size_t lines = 10'000;
  if (count > 1) {
    const std::string_view number(arguments[1]);
    std::from_chars(number.data(), number.data() + number.size(), lines);
  }
  std::fputs(proskill::bench::programOfLines(lines).c_str(), stdout);
}
