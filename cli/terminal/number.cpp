#include "cli/terminal/number.h"

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <system_error>

namespace proskill::cli {

namespace {

constexpr auto kLargest = std::numeric_limits<std::uint64_t>::max();
constexpr double kLongest = 1e9; // seconds; thirty years

/// \return whether all of the word is a number
template <class Number> std::errc readNumber(const std::string& word, Number& number) {
  const char* end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, number);
  return read.ec == std::errc() && read.ptr != end ? std::errc::invalid_argument : read.ec;
}

std::string boundsText(std::uint64_t least, std::uint64_t most) {
  if (most != kLargest) return fmt::format("an integer from {} to {}", least, most);
  return least == 0 ? "an integer" : "a positive integer";
}

} // namespace

CLI::Validator integerBetween(std::uint64_t least, std::uint64_t most) {
  return {[least, most](std::string& word) {
            std::uint64_t number = 0;
            const auto error = readNumber(word, number);
            if (error == std::errc() && number >= least && number <= most) return std::string();
            if (error == std::errc::result_out_of_range && most == kLargest)
              return fmt::format("`{}` is too large", word);
            return fmt::format("`{}` is not {}", word, boundsText(least, most));
          },
          ""};
}

CLI::Validator portNumber() { return integerBetween(0, std::numeric_limits<std::uint16_t>::max()); }

CLI::Validator secondsFromZero() {
  return {[](std::string& word) {
            double seconds = 0;
            const auto error = readNumber(word, seconds);
            return error == std::errc() && seconds >= 0 && seconds <= kLongest
                       ? std::string()
                       : fmt::format("`{}` is not a number of seconds from 0 to 1e9", word);
          },
          ""};
}

CLI::Validator positiveSeconds() {
  return {[](std::string& word) {
            double seconds = 0;
            const auto error = readNumber(word, seconds);
            return error == std::errc() && seconds > 0 && seconds <= kLongest
                       ? std::string()
                       : fmt::format("`{}` is not a number of seconds above 0, up to 1e9", word);
          },
          ""};
}

std::uint64_t bytesOfMiB(std::uint64_t mebibytes) {
  constexpr std::uint64_t kMebibyte = 1 << 20;
  return mebibytes > kLargest / kMebibyte ? kLargest : mebibytes * kMebibyte;
}

} // namespace proskill::cli
