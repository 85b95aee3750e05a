#include "embed/failure.h"

#include "syntax/diagnostics/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace proskill::embed {

namespace {

/// As `dlerror` and `errno` have it: callers in C own no text.
std::string& textOfThread() noexcept {
  thread_local std::string text;
  return text;
}

} // namespace

std::unexpected<Failure> failed(proskill_error code, std::string text) {
  return std::unexpected(Failure{code, std::move(text)});
}

std::unexpected<Failure> isNull(std::string_view argument) {
  return failed(PROSKILL_INVALID_ARGUMENT, fmt::format("`{}` must not be NULL", argument));
}

std::unexpected<Failure> unknownName(const std::string& what, std::string_view name,
                                     const std::vector<std::string>& names) {
  auto text = fmt::format("there is no {} `{}`", what, name);
  if (const auto meant = syntax::nearest(name, names); !meant.empty())
    text += fmt::format("; did you mean `{}`?", meant);
  return failed(PROSKILL_UNKNOWN_NAME, std::move(text));
}

std::expected<proskill_options, Failure> completed(const proskill_options* given) {
  constexpr auto kFirstVersion = offsetof(proskill_options, platform);
  proskill_options options = PROSKILL_OPTIONS;
  if (!given) return options;
  if (given->size < kFirstVersion)
    return failed(PROSKILL_INVALID_ARGUMENT, "options must begin as PROSKILL_OPTIONS");
  options.no_platform = given->size < sizeof options;
  std::memcpy(&options, given, std::min(given->size, sizeof options));
  return options;
}

std::expected<runtime::Nanoseconds, Failure> timeOf(double seconds, std::string_view argument) {
  constexpr double kMost = 1e9;
  if (!(seconds >= 0 && seconds <= kMost))
    return failed(PROSKILL_INVALID_ARGUMENT,
                  fmt::format("`{}` must be from 0 to a thousand million seconds", argument));
  return std::llround(seconds * static_cast<double>(runtime::kSecond));
}

proskill_error keep(Failure failure) noexcept {
  textOfThread() = std::move(failure.text);
  return failure.code;
}

const char* keptText() noexcept { return textOfThread().c_str(); }

} // namespace proskill::embed
