#pragma once

#include "cli/terminal/help.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <string>
#include <utility>
#include <vector>

namespace proskill::cli {

template <class Value> using Choices = std::vector<std::pair<std::string, Value>>;

template <class Value> std::string words(const Choices<Value>& choices, std::string_view between) {
  std::string text;
  for (const auto& [word, value] : choices)
    text += (text.empty() ? "" : std::string(between)) + word;
  return text;
}

/// An option with a fixed set of words, each for a value. Its help lists them.
template <class Value>
CLI::Option* addChoice(CLI::App& command, const std::string& name, Value& chosen,
                       const Choices<Value>& choices, const std::string& help,
                       const char* inGroup = group::kOutput) {
  auto choose = [&chosen, choices, name](const std::string& word) {
    for (const auto& [known, value] : choices)
      if (known == word) return static_cast<void>(chosen = value);
    throw CLI::ValidationError(name, "`" + word + "` is not one of " + words(choices, ", "));
  };
  auto* option = command.add_option_function<std::string>(name, choose, help);
  return show(option, inGroup, words(choices, "|"));
}

/// A positive, finite length of time in seconds; rejects `nan` and `1e999`.
inline CLI::Validator positiveSeconds() {
  constexpr double kLongest = 1e9; // thirty years
  return {[](std::string& word) {
            double seconds = 0;
            const char* end = word.data() + word.size();
            const auto read = std::from_chars(word.data(), end, seconds);
            const bool whole = read.ec == std::errc() && read.ptr == end;
            return whole && seconds > 0 && seconds <= kLongest
                       ? std::string()
                       : "`" + word + "` is not a number of seconds between 0 and 1e9";
          },
          ""};
}

} // namespace proskill::cli
