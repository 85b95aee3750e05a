#pragma once

#include "include/proskill/executor.h"
#include "runtime/machine/executable.h"

#include <exception>
#include <expected>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace proskill::embed {

/// Why a call failed: what the function returns, and the text for proskill_error_text.
struct Failure {
  proskill_error code = PROSKILL_SYSTEM_ERROR;
  std::string text;
};

using Done = std::expected<void, Failure>;

[[nodiscard]] std::unexpected<Failure> failed(proskill_error code, std::string text);
[[nodiscard]] std::unexpected<Failure> isNull(std::string_view argument);
/// With a suggestion, if a name is similar.
[[nodiscard]] std::unexpected<Failure> unknownName(const std::string& what, std::string_view name,
                                                   const std::vector<std::string>& names);

/// The options with the members that the caller's version of them does not have. Its program names
/// no platform for it.
/// \param given null: the default
[[nodiscard]] std::expected<proskill_options, Failure> completed(const proskill_options* given);

/// A time in seconds, which must not be negative, and is at most some thirty years.
[[nodiscard]] std::expected<runtime::Nanoseconds, Failure> timeOf(double seconds,
                                                                  std::string_view argument);

/// Keeps the text of a failure for this thread. \return its code
proskill_error keep(Failure failure) noexcept;
/// The text that was kept last.
[[nodiscard]] const char* keptText() noexcept;

/// Makes a call for another language: failures and exceptions become codes.
template <class Call> proskill_error answer(Call&& call) noexcept {
  try {
    Done done = call();
    return done ? PROSKILL_OK : keep(std::move(done.error()));
  } catch (const std::exception& error) {
    return keep({PROSKILL_SYSTEM_ERROR, error.what()});
  }
}

} // namespace proskill::embed
