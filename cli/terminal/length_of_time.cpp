#include "cli/terminal/length_of_time.h"

#include <charconv>
#include <cmath>

namespace proskill::cli {

namespace {

std::optional<runtime::Nanoseconds> lengthOfTime(std::string_view word) {
  const auto number = takeNumber(word);
  if (!number) return std::nullopt;
  for (const auto& [unit, seconds] :
       {std::pair{"", 1}, {"s", 1}, {"m", 60}, {"h", 3600}, {"d", 86400}})
    if (word == unit && *number * seconds <= 1e9)
      return std::llround(*number * seconds * static_cast<double>(runtime::kSecond));
  return std::nullopt;
}

} // namespace

std::optional<double> takeNumber(std::string_view& word) {
  double number = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  if (read.ec != std::errc() || !(number >= 0 && number <= 1e9)) return std::nullopt;
  word.remove_prefix(static_cast<std::size_t>(read.ptr - word.data()));
  return number;
}

CLI::Option* addLengthOfTime(CLI::App& command, const std::string& name,
                             std::optional<runtime::Nanoseconds>& chosen, const std::string& help,
                             const char* inGroup, runtime::Nanoseconds least) {
  const auto set = [&chosen, name, least](const std::string& word) {
    chosen = lengthOfTime(word);
    if (!chosen || *chosen < least)
      throw CLI::ValidationError(name, "`" + word + "` is not a time such as 90, 5m, 2h or 1d");
  };
  return show(command.add_option_function<std::string>(name, set, help), inGroup, "TIME");
}

} // namespace proskill::cli
