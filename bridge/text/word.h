#pragma once

#include "bridge/text/place.h"

#include <algorithm>
#include <string_view>

namespace proskill::bridge {

/// A part of a text, and where it begins.
struct Word {
  std::string text;
  Place place;
};

inline void append(std::vector<Word>& all, const std::vector<Word>& more) {
  all.insert(all.end(), more.begin(), more.end());
}
[[nodiscard]] inline bool has(const std::vector<Word>& words, std::string_view text) {
  return std::ranges::find(words, text, &Word::text) != words.end();
}

} // namespace proskill::bridge
