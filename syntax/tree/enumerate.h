#pragma once

#include <ranges>
#include <string>
#include <string_view>

namespace proskill::syntax {

/// Words as a list in a sentence: "Free, Busy or Lost" with `last` " or ".
template <std::ranges::sized_range Words>
[[nodiscard]] std::string enumerate(const Words& words, std::string_view last = " and ") {
  std::string text;
  std::size_t left = std::ranges::size(words);
  for (const auto& word : words) {
    if (!text.empty()) text += left == 1 ? last : ", ";
    text += word;
    --left;
  }
  return text;
}

/// Names as a list in a message: "`Free`, `Busy` and `Lost`".
template <std::ranges::sized_range Names>
[[nodiscard]] std::string enumerateNames(const Names& names) {
  return enumerate(names | std::views::transform([](const auto& name) {
                     return std::string("`").append(name).append("`");
                   }));
}

} // namespace proskill::syntax
