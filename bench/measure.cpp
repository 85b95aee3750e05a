#include "bench/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace proskill::bench {

double medianSeconds(const std::function<void()>& work, int times) {
  std::vector<double> all;
  for (int i = 0; i < times; ++i) {
    auto start = std::chrono::steady_clock::now();
    work();
    all.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::ranges::sort(all);
  return all[all.size() / 2];
}

void keep(std::size_t result) { asm volatile("" : : "r"(result) : "memory"); }

Table::Table(const std::string& title) {
  fmt::print("\n{}\n{:<46} {:>18}   {:<40} {:>9}\n{:-<118}\n", title, "", "", "against", "ratio",
             "");
}

void Table::add(const Row& row) const {
  std::string ratio = row.ratio > 0 ? fmt::format("{:.3g}", row.ratio) : "";
  fmt::print("{:<46} {:>18}   {:<40} {:>9}\n", row.what, row.figure, row.baseline, ratio);
  std::fflush(stdout);
}

std::string rate(double perSecond, const std::string& of) {
  if (perSecond >= 1e9) return fmt::format("{:.3g} G {}/s", perSecond / 1e9, of);
  if (perSecond >= 1e6) return fmt::format("{:.3g} M {}/s", perSecond / 1e6, of);
  if (perSecond >= 1e3) return fmt::format("{:.3g} k {}/s", perSecond / 1e3, of);
  return fmt::format("{:.3g} {}/s", perSecond, of);
}

std::string duration(double seconds) {
  if (seconds >= 1) return fmt::format("{:.3g} s", seconds);
  if (seconds >= 1e-3) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} us", seconds * 1e6);
}

} // namespace proskill::bench
