#include "syntax/diagnostics/codes.h"
#include "syntax/recovery/recover.h"
#include "syntax/text/nesting.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace proskill::syntax {
namespace {

// Limit of corrections. People can correct as many; random bytes would have no end.
constexpr std::size_t kMostMistakes = 16;
// Limit of landmarks and parentheses that are examined for one correction.
constexpr std::size_t kBudget = 1'000'000;
// The grammar judges only few corrections and places of short texts, since it takes longer.
constexpr std::size_t kMistakesJudged = 4;
constexpr std::size_t kPlacesJudged = 6;
constexpr std::size_t kLongestJudged = 1 << 14;
constexpr unsigned kWeightOfProblem = 3;
// A place that contradicts the layout by so much more than the best one is not judged.
constexpr unsigned kHopeless = 12;

/// A copy of the text with corrected parentheses and the same length.
std::string recovered(std::string text, const Scan& scan, const Recovery& recovery) {
  for (std::size_t i = 0; i < recovery.removed.size(); ++i)
    if (recovery.removed[i]) text[scan.parentheses[i].at] = ' ';
  for (std::size_t i = 0; i < recovery.inserted.size(); ++i) {
    Offset at = placeBefore(scan, i);
    // The length must not change, so added characters overwrite the space there, and a comment. If
    // that is too little, the parser closes the form at the end of the region.
    if (recovery.inserted[i] > 0)
      if (auto comment = std::ranges::find(scan.comments, at, &Range::begin);
          comment != scan.comments.end())
        std::fill(text.begin() + comment->begin, text.begin() + comment->end, ' ');
    for (unsigned count = recovery.inserted[i]; count > 0 && at < text.size(); --count, ++at) {
      if (text[at] != ' ' && !(text[at] >= '\t' && text[at] <= '\r')) break;
      text[at] = ')';
    }
  }
  return text;
}

class Balancing {
public:
  Balancing(const std::string& source, const Scan& scanned, const Judge& judgement,
            std::vector<Diagnostic>& out)
      : text(source), scan(scanned), judge(judgement), diagnostics(out) {
    recovery.removed.resize(scan.parentheses.size());
    recovery.inserted.resize(scan.landmarks.size() + 1);
  }

  /// The balanced text; nullopt if it was balanced.
  std::optional<std::string> run() {
    for (; mistakes < kMostMistakes; ++mistakes) {
      Nesting nesting = nestingOf(text, scan, recovery);
      if (nesting.surplus)
        removeOne(nesting);
      else if (!nesting.open.empty())
        insertOne(nesting);
      else
        break;
    }
    if (mistakes == 0) return std::nullopt;
    reportInsertions();
    return recovered(text, scan, recovery);
  }

private:
  /// A possible change, and how much the result contradicts the layout.
  struct Candidate {
    std::size_t place;
    unsigned penalty;
  };

  /// The landmarks before which an error may be, the likeliest first, as many as the budget allows.
  std::vector<std::size_t> suspects(const Nesting& nesting) const {
    std::vector<std::size_t> places(scan.landmarks.size());
    std::iota(places.begin(), places.end(), 0);
    std::ranges::stable_sort(places, std::greater{},
                             [&](std::size_t place) { return nesting.doubts[place]; });
    std::size_t cost = scan.parentheses.size() + scan.landmarks.size() + 1;
    places.resize(std::min(places.size(), std::max<std::size_t>(kBudget / cost, 1)));
    std::ranges::sort(places);
    return places;
  }

  /// The best candidate, the first among equals. `apply` makes a change, `revert` undoes it.
  std::size_t best(std::vector<Candidate> candidates, auto apply, auto revert) {
    std::ranges::stable_sort(candidates, {}, &Candidate::penalty);
    unsigned hopeless = candidates.front().penalty + kHopeless;
    std::erase_if(candidates, [&](const Candidate& it) { return it.penalty > hopeless; });
    bool judged = mistakes < kMistakesJudged && text.size() <= kLongestJudged;
    if (judged && candidates.size() > 1) {
      candidates.resize(std::min(candidates.size(), kPlacesJudged));
      for (Candidate& candidate : candidates) {
        apply(candidate.place);
        candidate.penalty +=
            static_cast<unsigned>(judge(recovered(text, scan, recovery))) * kWeightOfProblem;
        revert(candidate.place);
      }
      std::ranges::stable_sort(candidates, {}, &Candidate::penalty);
    }
    return candidates.front().place;
  }

  [[nodiscard]] bool startsLine(Offset at) const {
    auto landmark = std::ranges::lower_bound(scan.landmarks, at, {}, &Landmark::at);
    return landmark != scan.landmarks.end() && landmark->at == at;
  }

  void removeOne(Nesting& nesting) {
    std::vector<Candidate> candidates;
    auto apply = [&](std::size_t parenthesis) { recovery.removed[parenthesis] = true; };
    auto revert = [&](std::size_t parenthesis) { recovery.removed[parenthesis] = false; };
    auto consider = [&](std::size_t parenthesis, unsigned handicap) {
      if (!candidates.empty() && candidates.back().place == parenthesis) return;
      apply(parenthesis);
      candidates.push_back({parenthesis, nestingOf(text, scan, recovery).penalty + handicap});
      revert(parenthesis);
    };
    // a `)` at the start of a line is the likeliest to be superfluous
    bool standsAlone = startsLine(scan.parentheses[*nesting.surplus].at);
    for (std::size_t landmark : suspects(nesting)) {
      std::size_t before = scan.landmarks[landmark].parentheses;
      while (before > 0 && recovery.removed[before - 1]) --before;
      bool closes = before > 0 && !scan.parentheses[before - 1].opens;
      if (closes && before - 1 <= *nesting.surplus) consider(before - 1, standsAlone);
    }
    consider(*nesting.surplus, 0);
    std::size_t chosen = best(std::move(candidates), apply, revert);
    apply(chosen);
    reportSurplus(scan.parentheses[chosen].at);
  }

  void insertOne(Nesting& nesting) {
    std::vector<Candidate> candidates;
    auto apply = [&](std::size_t landmark) { ++recovery.inserted[landmark]; };
    auto revert = [&](std::size_t landmark) { --recovery.inserted[landmark]; };
    for (std::size_t landmark : suspects(nesting)) {
      apply(landmark);
      Nesting then = nestingOf(text, scan, recovery);
      bool unasked = nesting.doubts[landmark] == 0;
      if (!then.surplus) candidates.push_back({landmark, then.penalty + unasked});
      revert(landmark);
    }
    std::size_t end = scan.landmarks.size();
    apply(end);
    candidates.push_back({end, nestingOf(text, scan, recovery).penalty});
    revert(end);
    apply(best(std::move(candidates), apply, revert));
  }

  void reportSurplus(Offset at) {
    Range range{at, at + 1};
    auto& diagnostic =
        diagnostics.emplace_back(makeDiagnostic(Code::SurplusParenthesis, {0, range}));
    diagnostic.fixes.push_back({"remove `)`", {0, range}, ""});
  }

  /// Makes one report for each place where something is missing, at the innermost parenthesis.
  void reportInsertions() {
    auto closed = nestingOf(text, scan, recovery).closedByInsertion;
    auto next = closed.begin();
    for (std::size_t landmark = 0; landmark < recovery.inserted.size(); ++landmark) {
      std::ptrdiff_t count =
          std::min<std::ptrdiff_t>(recovery.inserted[landmark], closed.end() - next);
      if (count > 0) reportUnclosed({next, next + count}, placeBefore(scan, landmark));
      next += count;
    }
  }

  void reportUnclosed(std::span<const std::size_t> openers, Offset place) {
    auto location = [&](std::size_t opener) {
      Offset at = scan.parentheses[opener].at;
      return Location{0, {at, at + 1}};
    };
    auto& diagnostic = diagnostics.emplace_back(
        makeDiagnostic(Code::UnclosedParenthesis, location(openers.front())));
    for (std::size_t opener : openers.subspan(1))
      diagnostic.related.push_back({location(opener), "nor is this one"});
    std::string missing(openers.size(), ')');
    Location there{0, {place, place}};
    diagnostic.related.push_back({there, fmt::format("`{}` probably belongs here", missing)});
    diagnostic.fixes.push_back({fmt::format("insert `{}`", missing), there, missing});
  }

  const std::string& text;
  const Scan& scan;
  const Judge& judge;
  std::vector<Diagnostic>& diagnostics;
  Recovery recovery;
  std::size_t mistakes = 0;
};

} // namespace

bool recoverParentheses(std::string& text, const Scan& scan, const Judge& judge,
                        std::vector<Diagnostic>& diagnostics) {
  auto balanced = Balancing(text, scan, judge, diagnostics).run();
  if (balanced) text = std::move(*balanced);
  return balanced.has_value();
}

} // namespace proskill::syntax
