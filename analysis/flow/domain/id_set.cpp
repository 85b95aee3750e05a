#include "analysis/flow/domain/id_set.h"

#include <utility>

namespace proskill::analysis::flow {

namespace {

constexpr std::size_t kMuchSmaller = 8;

} // namespace

bool IdSet::insert(Run run) {
  auto first = std::ranges::lower_bound(runs, run.begin, {}, &Run::end); // touches or follows
  if (first == runs.end() || first->begin > run.end) {
    runs.insert(first, run);
    return true;
  }
  if (first->begin <= run.begin && run.end <= first->end) return false;
  auto last = std::ranges::upper_bound(first, runs.end(), run.end, {}, &Run::begin);
  *first = {std::min(first->begin, run.begin), std::max(std::prev(last)->end, run.end)};
  runs.erase(std::next(first), last);
  return true;
}

bool IdSet::insertAll(const IdSet& other) {
  if (other.runs.size() * kMuchSmaller < runs.size()) {
    bool grew = false;
    for (const Run& run : other.runs) grew |= insert(run);
    return grew;
  }
  if (other.runs.empty()) return false;
  std::vector<Run> merged;
  auto add = [&merged](Run run) {
    if (merged.empty() || merged.back().end < run.begin)
      merged.push_back(run);
    else
      merged.back().end = std::max(merged.back().end, run.end);
  };
  auto b = other.runs.begin();
  for (const Run& run : runs) {
    for (; b != other.runs.end() && b->begin < run.begin; ++b) add(*b);
    add(run);
  }
  for (; b != other.runs.end(); ++b) add(*b);
  bool grew = merged != runs;
  runs = std::move(merged);
  return grew;
}

void IdSet::eraseAll(const IdSet& other) {
  std::vector<Run> kept;
  auto b = other.runs.begin();
  for (Run run : runs) {
    while (b != other.runs.end() && b->end <= run.begin) ++b;
    for (auto hole = b; hole != other.runs.end() && hole->begin < run.end; ++hole) {
      if (hole->begin > run.begin) kept.push_back({run.begin, hole->begin});
      run.begin = std::min(std::max(run.begin, hole->end), run.end);
    }
    if (run.begin < run.end) kept.push_back(run);
  }
  runs = std::move(kept);
}

void IdSet::keepFirst(std::size_t most) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::size_t size = runs[i].end - runs[i].begin;
    if (size < most) {
      most -= size;
      continue;
    }
    runs[i].end = runs[i].begin + static_cast<std::uint32_t>(most);
    runs.resize(most == 0 ? i : i + 1);
    return;
  }
}

} // namespace proskill::analysis::flow
