#pragma once

#include <functional>
#include <string>
#include <vector>

namespace proskill::bench {

/// Duration of a piece of work in seconds: the median of `times` runs.
[[nodiscard]] double medianSeconds(const std::function<void()>& work, int times = 5);

/// Keeps the optimiser from removing work whose result is unused.
void keep(std::size_t result);

/// A row of a table: a measurement, and its ratio to a baseline of the same run.
struct Row {
  std::string what;
  std::string figure;   ///< with its unit
  std::string baseline; ///< name and value of the baseline
  double ratio = 0;     ///< 0: no baseline
};

/// Prints rows under a heading, as they come.
class Table {
public:
  explicit Table(const std::string& title);
  void add(const Row& row) const;
};

/// `12.3 M lines/s`, `1.2 ms`: three figures and a prefix.
[[nodiscard]] std::string rate(double perSecond, const std::string& of);
[[nodiscard]] std::string duration(double seconds);

} // namespace proskill::bench
