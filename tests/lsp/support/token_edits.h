#pragma once

#include "rpc/rpc.h"

namespace proskill::test {

/// Applies the protocol's edits to an array of tokens. All edits refer to the original array, and
/// must be ordered without overlaps; otherwise throws `std::runtime_error`.
[[nodiscard]] inline Json afterEdits(const Json& tokens, const Json& edits) {
  auto result = Json::array();
  std::size_t done = 0;
  auto copyTo = [&](std::size_t end) {
    if (end < done || end > tokens.size()) throw std::runtime_error("an edit out of order");
    while (done < end) result.push_back(tokens[done++]);
  };
  for (const auto& edit : edits) {
    copyTo(edit["start"]);
    done += edit["deleteCount"].get<std::size_t>();
    for (const auto& number : edit["data"]) result.push_back(number);
  }
  copyTo(tokens.size());
  return result;
}

} // namespace proskill::test
