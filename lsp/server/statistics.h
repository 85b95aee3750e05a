#pragma once

#include "rpc/rpc.h"

#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::lsp {

/// Count and duration of requests per method, for `proskill/status`.
class Statistics {
public:
  void add(std::string_view method, std::chrono::nanoseconds latency);
  /// Per method: `count`, `p50`, `p99` and `max` in milliseconds, over the last thousand of each.
  [[nodiscard]] Json latencies() const;

private:
  struct Series {
    std::size_t count = 0;
    std::vector<double> recent; ///< milliseconds; a ring buffer once it is full
  };

  static constexpr std::size_t kKept = 1000;

  mutable std::mutex mutex;
  std::map<std::string, Series, std::less<>> series;
};

/// Of this process, in bytes; 0 if unknown.
[[nodiscard]] std::size_t residentBytes();

} // namespace proskill::lsp
