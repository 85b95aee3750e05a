#include "verify/state/guard_tables.h"

#include <bit>

namespace proskill::verify {

namespace {

constexpr int kMostBits = 8; ///< of a cell; others are not tabled
constexpr std::size_t kMostTransitions = 4096;
constexpr std::size_t kMostWords = std::size_t{1} << 15; ///< of all sets

bool isTabled(const Cell& cell) { return cell.mask != 0 && std::popcount(cell.mask) <= kMostBits; }

bool isIn(const Cell& cell, const BitTest& test) {
  return cell.word == test.word && (cell.mask & test.mask) != 0;
}

/// Whether what a test excludes can be said of a cell alone. A test for equality of several cells
/// is one test for each of them.
bool isSplitBy(const Cell& cell, const BitTest& test) {
  return isIn(cell, test) && (test.equal || (test.mask & ~cell.mask) == 0);
}

/// Whether a test excludes a value, which is given in its place in the word.
bool isExcluded(const Cell& cell, Word value, const BitTest& test) {
  return ((value & test.mask) == (test.value & cell.mask)) != test.equal;
}

} // namespace

/// Adds what one cell after the other excludes.
class GuardTables::Maker {
public:
  Maker(const System& of, GuardTables& to) : system(of), tables(to), testsOf(of.words) {
    eachIn(tables.all, [&](TransitionId id) {
      for (const auto& test : system.transitions[id].tests)
        testsOf[test.word].push_back({id, &test});
    });
  }

  void add(const Cell& cell) {
    if (!isTabled(cell)) return;
    const std::vector<TestOf> tests = testsSplitBy(cell);
    if (tests.empty()) return;
    const std::size_t first = tables.sets.size();
    bool excludes = false;
    for (Word value = 0; value <= cell.mask >> cell.shift; ++value) {
      const std::size_t at = tables.sets.size();
      tables.sets.insert(tables.sets.end(), tables.all.begin(), tables.all.end());
      for (const auto& [transition, test] : tests) {
        if (!isExcluded(cell, value << cell.shift, *test)) continue;
        tables.sets[at + transition / 64] &= ~(Word{1} << (transition % 64));
        excludes = true;
      }
    }
    if (!excludes) return tables.sets.resize(first);
    tables.fields.push_back(
        {cell.word, cell.shift, cell.mask >> cell.shift, static_cast<std::uint32_t>(first)});
  }

  /// Notes the transitions with conditions that the tables do not express.
  void findOthers() {
    eachIn(tables.all, [&](TransitionId id) {
      const Transition& transition = system.transitions[id];
      if (!transition.rest.empty() || transition.tentative) insert(tables.others, id);
    });
    std::vector<std::vector<const Cell*>> cellsOf(system.words);
    for (const auto& cell : system.cells)
      if (isTabled(cell)) cellsOf[cell.word].push_back(&cell);
    for (std::size_t word = 0; word < testsOf.size(); ++word)
      for (const auto& [transition, test] : testsOf[word]) {
        Word split = 0;
        for (const Cell* cell : cellsOf[word])
          if (isSplitBy(*cell, *test)) split |= cell->mask;
        if ((test->mask & ~split) != 0) insert(tables.others, transition);
      }
  }

private:
  struct TestOf {
    TransitionId transition = 0;
    const BitTest* test = nullptr;
  };

  [[nodiscard]] std::vector<TestOf> testsSplitBy(const Cell& cell) const {
    std::vector<TestOf> split;
    for (const auto& each : testsOf[cell.word])
      if (isSplitBy(cell, *each.test)) split.push_back(each);
    return split;
  }

  const System& system;
  GuardTables& tables;
  std::vector<std::vector<TestOf>> testsOf; ///< by word of the state
};

GuardTables::GuardTables(const System& system, const TransitionSet& possible)
    : all(possible), others(possible.size()) {
  if (system.transitions.size() > kMostTransitions) return;
  Maker maker(system, *this);
  const auto isFast = [&] { return fields.size() * all.size() <= system.transitions.size(); };
  for (const auto& cell : system.cells)
    if (isFast() && sets.size() <= kMostWords) maker.add(cell);
  if (isFast() && sets.size() <= kMostWords) {
    maker.findOthers();
  } else {
    fields.clear();
    sets.clear();
  }
}

void GuardTables::findCandidates(const Word* state, TransitionSet& candidates) const {
  candidates = all;
  const std::size_t words = all.size();
  for (const auto& field : fields) {
    const Word value = state[field.word] >> field.shift & field.mask;
    const Word* left = &sets[field.first + value * words];
    for (std::size_t k = 0; k < words; ++k) candidates[k] &= left[k];
  }
}

} // namespace proskill::verify
