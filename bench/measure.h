#pragma once

#include <functional>
#include <string>
#include <vector>

namespace proskill::bench {

/// How long a piece of work takes, in seconds: the median of `times` runs.
[[nodiscard]] double medianSeconds(const std::function<void()>& work, int times = 5);

/// Keeps the optimiser from leaving out work whose result nobody needs.
void keep(std::size_t result);

/// One line of a table: what was measured, and the same in terms of a baseline of the same run.
struct Row {
  std::string what;
  std::string figure;   ///< with its unit
  std::string baseline; ///< what it is compared with, and its figure
  double ratio = 0;     ///< 0: there is nothing to compare with
};

/// Prints rows as they come, under one heading.
class Table {
public:
  explicit Table(const std::string& title);
  void add(const Row& row) const;
};

/// `12.3 M lines/s`, `1.2 ms`: three figures and a prefix.
[[nodiscard]] std::string rate(double perSecond, const std::string& of);
[[nodiscard]] std::string duration(double seconds);

} // namespace proskill::bench
