#include "syntax/text/nesting.h"

namespace proskill::syntax {
namespace {

// Weights of contradictions. Layouts vary, so a hint must not outweigh a certain error.
constexpr unsigned kCertain = 4;
constexpr unsigned kHint = 1;

class Walk {
public:
  Walk(std::string_view source, const Scan& scanned, const Recovery& changes)
      : text(source), scan(scanned), recovery(changes) {}

  Nesting run() {
    result.doubts.resize(scan.landmarks.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < scan.landmarks.size(); ++i) {
      for (; next < scan.landmarks[i].parentheses; ++next) pass(next);
      insert(i);
      judge(i);
    }
    for (; next < scan.parentheses.size(); ++next) pass(next);
    insert(scan.landmarks.size());
    for (const Opener& opener : stack) result.open.push_back(opener.parenthesis);
    result.penalty += static_cast<unsigned>(stack.size()) * kCertain;
    return std::move(result);
  }

private:
  struct Opener {
    std::size_t parenthesis;
    Offset column;
    bool ofLists; ///< followed by another `(`
    std::optional<Offset> contentColumn;
  };

  [[nodiscard]] bool opensAt(Offset at) const { return at < text.size() && text[at] == '('; }

  void pass(std::size_t index) {
    const Parenthesis& parenthesis = scan.parentheses[index];
    if (recovery.removed[index]) return;
    if (parenthesis.opens) {
      if (stack.empty() && !outerColumn) outerColumn = parenthesis.column;
      formsInField = stack.empty() ? 0 : formsInField + (stack.size() == 1);
      stack.push_back({index, parenthesis.column, opensAt(parenthesis.at + 1), {}});
    } else if (!stack.empty()) {
      stack.pop_back();
    } else {
      result.penalty += kCertain;
      if (!result.surplus) result.surplus = index;
    }
  }

  void insert(std::size_t landmark) {
    for (unsigned i = 0; i < recovery.inserted[landmark] && !stack.empty(); ++i) {
      result.closedByInsertion.push_back(stack.back().parenthesis);
      stack.pop_back();
    }
  }

  void judge(std::size_t index) {
    const Landmark& landmark = scan.landmarks[index];
    unsigned weight = 0;
    if (landmark.fieldOfDefinition && stack.size() != 1) weight += kCertain;
    if (landmark.keyword && stack.size() == 1) formsInField = 0;
    if (landmark.startsLine && text[landmark.at] != ')') weight += judgeLine(landmark);
    result.penalty += weight;
    result.doubts[index] = weight;
  }

  unsigned judgeLine(const Landmark& landmark) {
    if (stack.empty()) {
      bool form = opensAt(landmark.at) && (!outerColumn || landmark.column <= *outerColumn);
      return form ? 0 : kCertain;
    }
    unsigned weight = 0;
    for (std::size_t i = stack.size(); i-- > 0 && stack[i].column >= landmark.column;)
      weight += isSibling(stack[i], landmark) ? kCertain : kHint;
    // the value of a field is at most one form
    if (stack.size() == 1 && opensAt(landmark.at) && formsInField > 0) weight += kCertain;
    auto& content = stack.back().contentColumn;
    if (content && *content != landmark.column) weight += kHint;
    if (!content) content = landmark.column;
    return weight;
  }

  /// Whether the line must be beside the opener, not in it: it is indented less, or begins like it.
  [[nodiscard]] bool isSibling(const Opener& opener, const Landmark& landmark) const {
    bool alike = opener.ofLists == (opensAt(landmark.at) && opensAt(landmark.at + 1));
    return landmark.column < opener.column || alike;
  }

  std::string_view text;
  const Scan& scan;
  const Recovery& recovery;
  std::vector<Opener> stack;
  std::optional<Offset> outerColumn; ///< of the first form
  unsigned formsInField = 0;         ///< number of forms in a definition since its last keyword
  Nesting result;
};

} // namespace

Nesting nestingOf(std::string_view text, const Scan& scan, const Recovery& recovery) {
  return Walk(text, scan, recovery).run();
}

} // namespace proskill::syntax
