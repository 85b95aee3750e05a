#include "lsp/server/statistics.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <unistd.h>

namespace proskill::lsp {

namespace {

/// \pre `sorted` is not empty
double quantile(const std::vector<double>& sorted, double part) {
  auto index = static_cast<std::size_t>(std::lround(part * static_cast<double>(sorted.size() - 1)));
  return sorted[index];
}

} // namespace

void Statistics::add(std::string_view method, std::chrono::nanoseconds latency) {
  auto milliseconds = std::chrono::duration<double, std::milli>(latency).count();
  std::lock_guard lock(mutex);
  auto& entry = series[std::string(method)];
  if (entry.recent.size() < kKept)
    entry.recent.push_back(milliseconds);
  else
    entry.recent[entry.count % kKept] = milliseconds;
  ++entry.count;
}

Json Statistics::latencies() const {
  std::lock_guard lock(mutex);
  Json result = Json::object();
  for (const auto& [method, entry] : series) {
    auto sorted = entry.recent;
    std::ranges::sort(sorted);
    result[method] = {{"count", entry.count},
                      {"p50", quantile(sorted, 0.5)},
                      {"p99", quantile(sorted, 0.99)},
                      {"max", sorted.back()}};
  }
  return result;
}

std::size_t residentBytes() {
  std::ifstream statm("/proc/self/statm");
  std::size_t total = 0;
  std::size_t resident = 0;
  statm >> total >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

} // namespace proskill::lsp
