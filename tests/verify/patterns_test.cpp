#include "tests/support/random/random_source.h"
#include "tests/support/text_model.h"

#include <catch2/catch.hpp>

#include <functional>
#include <map>

/// Compares patterns with scopes with the formulas that Dwyer, Avrunin and Corbett publish for them
/// ("Patterns in property specifications for finite-state verification", ICSE 1999, and
/// https://matthewbdwyer.github.io/psp/patterns/ltl.html), on cyclic runs.
using namespace proskill;
using test::RandomSource;
using test::Text;

namespace {

/// An infinite run: its letters, and the one that follows the last.
struct Lasso {
  std::vector<std::string> letters; ///< each a set of p, q, r, s
  std::size_t loop = 0;
};

/// The truth of a formula at every letter.
class Formula {
public:
  using Truths = std::vector<bool>;
  using Meaning = std::function<Truths(const Lasso&)>;
  explicit Formula(Meaning of) : meaning(std::move(of)) {}
  explicit Formula(char atom)
      : meaning([atom](const Lasso& run) {
          Truths all;
          for (const auto& letter : run.letters)
            all.push_back(letter.find(atom) != std::string::npos);
          return all;
        }) {}

  [[nodiscard]] Truths in(const Lasso& run) const { return meaning(run); }
  [[nodiscard]] bool isTrue(const Lasso& run) const { return meaning(run)[0]; }

private:
  Meaning meaning;
};

Formula no(const Formula& of) {
  return Formula([of](const Lasso& run) {
    auto all = of.in(run);
    all.flip();
    return all;
  });
}

Formula both(const Formula& a, const Formula& b) {
  return Formula([a, b](const Lasso& run) {
    auto all = a.in(run);
    const auto other = b.in(run);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = all[i] && other[i];
    return all;
  });
}

Formula either(const Formula& a, const Formula& b) { return no(both(no(a), no(b))); }
Formula implies(const Formula& a, const Formula& b) { return either(no(a), b); }

/// The least solution of: b, or a and the same at the next letter.
Formula until(const Formula& a, const Formula& b) {
  return Formula([a, b](const Lasso& run) {
    const auto first = a.in(run);
    auto all = b.in(run);
    for (std::size_t round = 0; round < 2; ++round)
      for (std::size_t i = all.size(); i-- > 0;) {
        const std::size_t next = i + 1 < all.size() ? i + 1 : run.loop;
        all[i] = all[i] || (first[i] && all[next]);
      }
    return all;
  });
}

Formula finally(const Formula& a) { return until(either(a, no(a)), a); }
Formula always(const Formula& a) { return no(finally(no(a))); }
Formula weakly(const Formula& a, const Formula& b) { return either(until(a, b), always(a)); }

struct Case {
  std::string pattern; ///< with p, q, r, s for what is observed
  Formula published;
};

std::vector<Case> cases() {
  const Formula p('p');
  const Formula q('q');
  const Formula r('r');
  const Formula s('s');
  const Formula begun = both(q, no(r));
  const Formula ends = both(begun, finally(r));
  const auto part = [&](const Formula& when, const Formula& then) {
    return always(implies(when, then));
  };
  const Formula responds = implies(p, until(no(r), both(s, no(r))));
  return {
      {"absent p", always(no(p))},
      {"absent p before r", implies(finally(r), until(no(p), r))},
      {"absent p after q", part(q, always(no(p)))},
      {"absent p between q and r", part(ends, until(no(p), r))},
      {"absent p after q until r", part(begun, weakly(no(p), r))},
      {"present p", finally(p)},
      {"present p after q", either(always(no(q)), finally(both(q, finally(p))))},
      {"present p after q until r", part(begun, until(no(r), both(p, no(r))))},
      {"present p between q and r", part(begun, weakly(no(r), both(p, no(r))))},
      {"present p before r", weakly(no(r), both(p, no(r)))},
      {"always p", always(p)},
      {"always p before r", implies(finally(r), until(p, r))},
      {"always p after q", part(q, always(p))},
      {"always p between q and r", part(ends, until(p, r))},
      {"always p after q until r", part(begun, weakly(p, r))},
      {"s precedes p", weakly(no(p), s)},
      {"s precedes p before r", implies(finally(r), until(no(p), either(s, r)))},
      {"s precedes p between q and r", part(ends, until(no(p), either(s, r)))},
      {"s precedes p after q until r", part(begun, weakly(no(p), either(s, r)))},
      {"p leadsto s", part(p, finally(s))},
      {"p leadsto s before r", implies(finally(r), until(responds, r))},
      {"p leadsto s after q", part(q, part(p, finally(s)))},
      {"p leadsto s between q and r", part(ends, until(responds, r))},
      {"p leadsto s after q until r", part(begun, weakly(responds, r))},
      // From the first q, like all scopes. The published `<>(q & (!p W s))` accepts any q that p
      // does not follow too early: a second q would excuse what came after the first.
      {"s precedes p after q", weakly(no(q), both(q, weakly(no(p), s)))},
      {"infinitelyoften p", always(finally(p))},
      {"mortal p", finally(always(no(p)))},
  };
}

Lasso lasso(RandomSource& random) {
  Lasso run;
  for (std::size_t i = 1 + random.below(6); i > 0; --i) {
    std::string letter;
    for (const char atom : {'p', 'q', 'r', 's'})
      if (random.chance(30)) letter += atom;
    run.letters.push_back(letter);
  }
  run.loop = random.below(run.letters.size());
  return run;
}

/// A process that goes from letter to letter.
Text model(const Lasso& run) {
  std::string states;
  std::string steps;
  for (std::size_t i = 0; i < run.letters.size(); ++i) {
    const std::size_t next = i + 1 < run.letters.size() ? i + 1 : run.loop;
    states += (i == 0 ? "l" : ", l") + std::to_string(i);
    steps += " from l" + std::to_string(i) + " to l" + std::to_string(next);
  }
  return Text("process P is states " + states + steps + "\ncomponent main is par * in P end");
}

/// The pattern on the letters of a run.
std::string asked(const std::string& pattern, const Lasso& run) {
  std::string text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool alone =
        (i == 0 || pattern[i - 1] == ' ') && (i + 1 == pattern.size() || pattern[i + 1] == ' ');
    if (!alone) {
      text += pattern[i];
      continue;
    }
    std::string where = "(main/1/value false)";
    for (std::size_t at = 0; at < run.letters.size(); ++at)
      if (run.letters[at].find(pattern[i]) != std::string::npos)
        where = "(" + where + " or (main/1/state l" + std::to_string(at) + "))";
    text += where;
  }
  return text;
}

} // namespace

TEST_CASE("patterns with scopes mean what is published for them") {
  RandomSource random(7);
  std::map<std::string, std::pair<int, int>> seen; ///< how often true, how often false
  for (int round = 0; round < 150; ++round) {
    const Lasso run = lasso(random);
    const Text text = model(run);
    for (const auto& [pattern, published] : cases()) {
      const bool expected = published.isTrue(run);
      const std::string question = asked(pattern, run);
      INFO(pattern << ", as " << question << ", loop at " << run.loop
                   << ", published: " << (expected ? "true" : "false"));
      CHECK(text.isTrue(question) == expected);
      ++(expected ? seen[pattern].first : seen[pattern].second);
    }
  }
  const Lasso excused{.letters = {"", "q", "p", "q", "s", ""}, .loop = 5};
  const Formula before = weakly(no(Formula('p')), Formula('s'));
  CHECK(finally(both(Formula('q'), before)).isTrue(excused));
  CHECK(model(excused).isFalse(asked("s precedes p after q", excused)));
  for (const auto& [pattern, times] : seen) {
    INFO(pattern);
    CHECK(times.first > 5);
    CHECK(times.second > 5);
  }
}
