#pragma once

#include "verify/ranks/exchange.h"

#include <string_view>
#include <unordered_set>

namespace proskill::verify {

/// Counts the different items of all ranks. Each is sent to the rank that its hash names.
class DistinctCount {
public:
  /// \pre the argument outlives this
  explicit DistinctCount(Ranks& over);

  void add(std::string_view item);
  /// Call this on all ranks, once.
  [[nodiscard]] std::uint64_t total();
  [[nodiscard]] const Traffic& sent() const { return exchange.sent(); }

private:
  Ranks& ranks;
  Exchange exchange;
  std::unordered_set<std::string> items; ///< of this rank
};

} // namespace proskill::verify
