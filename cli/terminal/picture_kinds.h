#pragma once

#include "cli/terminal/choice.h"
#include "viz/pictures.h"

#include <algorithm>

namespace proskill::cli {

inline const Choices<viz::Kind> kPictureKinds(viz::kKindWords.begin(), viz::kKindWords.end());

template <class Value>
[[nodiscard]] const std::string& wordOf(const Choices<Value>& choices, Value value) {
  return std::ranges::find(choices, value, &Choices<Value>::value_type::second)->first;
}

} // namespace proskill::cli
