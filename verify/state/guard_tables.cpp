#include "verify/state/guard_tables.h"

#include <bit>

namespace proskill::verify {

namespace {

constexpr int kMostBits = 8; ///< of a cell; others are not tabled
constexpr std::size_t kMostTransitions = 4096;
constexpr std::size_t kMostWords = std::size_t{1} << 15; ///< of all sets

bool isIn(const Cell& cell, const BitTest& test) {
  return cell.word == test.word && (cell.mask & test.mask) != 0;
}

/// Whether what a test excludes can be said of a cell alone. A test for equality of several cells
/// is one test for each of them.
bool isSplitBy(const Cell& cell, const BitTest& test) {
  return std::popcount(cell.mask) <= kMostBits && isIn(cell, test) &&
         (test.equal || (test.mask & ~cell.mask) == 0);
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
    const std::size_t first = tables.sets.size();
    bool excludes = false;
    if (cell.mask == 0 || std::popcount(cell.mask) > kMostBits) return;
    for (Word value = 0; value <= cell.mask >> cell.shift; ++value) {
      TransitionSet left = tables.all;
      for (const auto& [transition, test] : testsOf[cell.word])
        if (isSplitBy(cell, *test) && isExcluded(cell, value << cell.shift, *test))
          erase(left, transition);
      excludes = excludes || left != tables.all;
      tables.sets.insert(tables.sets.end(), left.begin(), left.end());
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
      if (cell.mask != 0) cellsOf[cell.word].push_back(&cell);
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

  const System& system;
  GuardTables& tables;
  std::vector<std::vector<TestOf>> testsOf; ///< by word of the state
};

GuardTables::GuardTables(const System& system, const TransitionSet& possible)
    : all(possible), others(possible.size()) {
  if (system.transitions.size() > kMostTransitions) return;
  Maker maker(system, *this);
  for (const auto& cell : system.cells)
    if (sets.size() <= kMostWords) maker.add(cell);
  const bool isFast = fields.size() * all.size() <= system.transitions.size();
  if (isFast && sets.size() <= kMostWords) {
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
