#pragma once

#include "cli/terminal/help.h"
#include "cli/terminal/usage.h"

#include <CLI/CLI.hpp>

#include <string>
#include <utility>
#include <vector>

namespace proskill::cli {

template <class Value> using Choices = std::vector<std::pair<std::string, Value>>;

template <class Value> std::vector<std::string> wordsOf(const Choices<Value>& choices) {
  std::vector<std::string> words;
  for (const auto& [word, value] : choices) words.push_back(word);
  return words;
}

/// ` (default WORD)`, or nothing if no word has the value.
template <class Value> std::string defaultOf(const Value& chosen, const Choices<Value>& choices) {
  for (const auto& [word, value] : choices)
    if (value == chosen) return " (default " + word + ")";
  return "";
}

/// An option with a fixed set of words, each for a value. Its help lists them, and says which word
/// the given value has. An argument has no default.
template <class Value>
CLI::Option* addChoice(CLI::App& command, const std::string& name, Value& chosen,
                       const Choices<Value>& choices, const std::string& help,
                       const char* inGroup = group::kOutput) {
  auto choose = [&chosen, choices, name](const std::string& word) {
    for (const auto& [known, value] : choices)
      if (known == word) return static_cast<void>(chosen = value);
    throw CLI::ValidationError(name, notOneOf(word, wordsOf(choices)));
  };
  const auto known = name.starts_with('-') ? defaultOf(chosen, choices) : std::string();
  auto* option = command.add_option_function<std::string>(name, choose, help + known);
  return show(option, inGroup, CLI::detail::join(wordsOf(choices), "|"));
}

} // namespace proskill::cli
