#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace proskill::analysis::flow {

/// A set of small integers, stored as intervals. Sets of processes are mostly "the processes that
/// this one calls" or "all but this one", and a program may have very many processes.
class IdSet {
public:
  [[nodiscard]] bool empty() const { return runs.empty(); }
  [[nodiscard]] bool contains(std::size_t id) const {
    auto run = after(id);
    return run != runs.begin() && id < std::prev(run)->end;
  }
  [[nodiscard]] bool intersects(const IdSet& other) const {
    return walk(other, [](std::uint32_t, std::uint32_t) { return true; });
  }
  void insert(std::size_t id) {
    auto first = static_cast<std::uint32_t>(id);
    insert(Run{first, first + 1});
  }
  void erase(std::size_t id) {
    auto first = static_cast<std::uint32_t>(id);
    eraseAll(IdSet({first, first + 1}));
  }
  /// \return whether the set has grown
  bool insertAll(const IdSet& other);
  void eraseAll(const IdSet& other);
  /// Removes all but the `most` smallest members.
  void keepFirst(std::size_t most);
  [[nodiscard]] IdSet common(const IdSet& other) const {
    IdSet both;
    walk(other, [&](std::uint32_t begin, std::uint32_t end) {
      both.runs.push_back({begin, end});
      return false;
    });
    return both;
  }

  friend auto operator<=>(const IdSet&, const IdSet&) = default;

  IdSet() = default;

private:
  /// From `begin` up to but excluding `end`. Intervals are ascending and not adjacent.
  struct Run {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    friend auto operator<=>(const Run&, const Run&) = default;
  };

  explicit IdSet(Run run) : runs{run} {}

  /// \return whether the set has grown
  bool insert(Run run);

  /// The first interval that begins after the number.
  [[nodiscard]] std::vector<Run>::const_iterator after(std::size_t id) const {
    return std::ranges::upper_bound(runs, id, {}, &Run::begin);
  }
  /// Calls `visit` for each common interval until it returns true.
  template <class Visit> bool walk(const IdSet& other, Visit&& visit) const {
    for (auto a = runs.begin(), b = other.runs.begin(); a != runs.end() && b != other.runs.end();) {
      std::uint32_t begin = std::max(a->begin, b->begin);
      std::uint32_t end = std::min(a->end, b->end);
      if (begin < end && visit(begin, end)) return true;
      if (a->end < b->end)
        ++a;
      else
        ++b;
    }
    return false;
  }

  template <class Visit> friend void forEach(const IdSet& set, Visit&& visit);
  std::vector<Run> runs;
};

/// In ascending order.
template <class Visit> void forEach(const IdSet& set, Visit&& visit) {
  for (const auto& run : set.runs)
    for (std::size_t id = run.begin; id < run.end; ++id) visit(id);
}

} // namespace proskill::analysis::flow
