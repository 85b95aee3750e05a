#include "verify/sample/new_values.h"

#include "verify/state/evaluate.h"

namespace proskill::verify {

namespace {

constexpr std::int64_t kMostOfCell = 4'096;     ///< values of a cell
constexpr std::size_t kMostPairs = 100'000'000; ///< bits

} // namespace

NewValues::NewValues(const System& of)
    : system(of),
      first(of.cells.size(), kUntracked),
      isNumber(of.cells.size()),
      now(of.cells.size()) {
  std::size_t count = 0;
  for (CellId i = 0; i < of.cells.size(); ++i) {
    const auto size = of.cells[i].high - of.cells[i].low + 1;
    if (size < 2 || size > kMostOfCell) continue;
    first[i] = static_cast<std::uint32_t>(count);
    tracked.push_back(i);
    count += static_cast<std::size_t>(size);
  }
  values.resize(count);
  pairs.resize(count);
  std::size_t ofNumbers = 0;
  for (const auto& watched : of.watched) {
    const auto& cell = of.cells[watched.cell];
    if (!watched.words.empty() || first[watched.cell] == kUntracked) continue;
    ofNumbers += static_cast<std::size_t>(cell.high - cell.low + 1);
    if (isNumber[watched.cell] || ofNumbers * count > kMostPairs) continue;
    isNumber[watched.cell] = true;
    numbers.push_back(watched.cell);
  }
}

std::uint32_t NewValues::read(CellId cell, const Word* state) const {
  return first[cell] +
         static_cast<std::uint32_t>(readCell(system, cell, state) - system.cells[cell].low);
}

void NewValues::goTo(const Word* state) {
  for (auto cell : tracked) now[cell] = read(cell, state);
}

NewValues::Kind NewValues::see(TransitionId step, const Word* state) {
  const auto& writes = system.transitions[step].writes;
  Kind kind = Kind::None;
  writes.each([&](CellId cell) {
    if (first[cell] == kUntracked) return;
    now[cell] = read(cell, state);
    if (values[now[cell]]) return;
    values[now[cell]] = true;
    kind = Kind::Value;
  });
  writes.each([&](CellId cell) {
    if (first[cell] != kUntracked && seePairs(cell) && kind == Kind::None) kind = Kind::Pair;
  });
  return kind;
}

/// Sees the pairs that have the value of this cell. \return whether any is new
bool NewValues::seePairs(CellId cell) {
  bool isNew = false;
  if (isNumber[cell])
    for (auto other : tracked) isNew = seePair(cell, other) || isNew;
  else
    for (auto number : numbers) isNew = seePair(number, cell) || isNew;
  return isNew;
}

bool NewValues::seePair(CellId number, CellId other) {
  auto& row = pairs[now[number]];
  if (row.empty()) row.resize(values.size());
  if (row[now[other]]) return false;
  row[now[other]] = true;
  return true;
}

} // namespace proskill::verify
