#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

/// Messages about wrong command lines.
namespace proskill::cli {

/// What is wrong, in a sentence, with the option or command that was probably meant.
/// \param app whose parsing ended with this error
[[nodiscard]] std::string usageMessage(const CLI::App& app, const CLI::Error& error);

/// That a word is none of those that an option takes.
[[nodiscard]] std::string notOneOf(std::string_view word, const std::vector<std::string>& words);

/// `; did you mean …?`, or nothing if no word is close enough.
[[nodiscard]] std::string didYouMean(std::string_view misspelt,
                                     const std::vector<std::string>& words);

} // namespace proskill::cli
