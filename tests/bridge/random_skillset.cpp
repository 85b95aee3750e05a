#include "tests/bridge/random_skillset.h"

#include "tests/support/random/random_source.h"

#include <fmt/format.h>

namespace proskill::test {
namespace {

class Writer {
public:
  explicit Writer(std::uint64_t seed) : random(seed) {
    for (std::size_t i = 1 + random.below(3); i > 0; --i) states.push_back(2 + random.below(2));
  }

  std::string skillset() {
    std::string text = "skillset s {\n";
    for (std::size_t i = 0; i < states.size(); ++i) text += resource(i);
    for (std::size_t i = random.below(4); i > 0; --i) text += event(i);
    for (std::size_t i = 1 + random.below(2); i > 0; --i) text += skill(i - 1);
    return text + "}\n";
  }

private:
  static std::string state(std::size_t number) { return fmt::format("S{}", number); }

  std::string resource(std::size_t number) {
    std::string all;
    for (std::size_t i = 0; i < states[number]; ++i) all += state(i) + " ";
    std::string moves = "transition all";
    if (random.chance(40)) {
      moves = "transition {";
      for (std::size_t from = 0; from < states[number]; ++from)
        for (std::size_t to = 0; to < states[number]; ++to)
          if (random.chance(50)) moves += fmt::format(" {} -> {}", state(from), state(to));
      moves += " }";
    }
    return fmt::format("resource r{} {{ state {{ {}}} initial {} {} }}\n", number, all,
                       state(random.below(states[number])), moves);
  }

  std::string event(std::size_t number) {
    const auto guard = random.chance(60) ? "guard " + condition(2) + " " : "";
    return fmt::format("event e{} {{ {}effect {} }}\n", number, guard, effects());
  }

  std::string skill(std::size_t number) {
    auto text = fmt::format("skill k{} {{\n", number);
    for (std::size_t i = random.below(3); i > 0; --i)
      text += fmt::format("  precondition p{}: {}\n", i, condition(2));
    if (random.chance(60)) text += "  start " + effects() + "\n";
    for (std::size_t i = random.below(3); i > 0; --i)
      text += fmt::format("  invariant i{} {{ guard {} {}}}\n", i, condition(1), optional());
    if (random.chance(50))
      text += fmt::format("  interrupt {{ interrupting {} {}}}\n", random.chance(50), optional());
    text += fmt::format("  success {{ ok {{ {}}} {}}}\n", optional(),
                        random.chance(30) ? "fine { } " : "");
    if (random.chance(50))
      text += fmt::format("  failure ko {{ {}postcondition {} }}\n", optional(), condition(1));
    return text + "}\n";
  }

  std::string optional() { return random.chance(60) ? "effect " + effects() + " " : ""; }

  std::string effects() {
    std::string text = "{";
    const auto first = random.below(states.size());
    for (std::size_t i = 0; i < states.size(); ++i)
      if (i == first || random.chance(25))
        text += fmt::format(" r{} -> {}", i, state(random.below(states[i])));
    return text + " }";
  }

  std::string condition(int depth) {
    if (depth == 0 || random.chance(40)) return comparison();
    switch (random.below(6)) {
    case 0: return "not " + condition(0);
    case 1: return "not (" + condition(depth - 1) + ")";
    case 2: return condition(0) + " => " + condition(0) + " => " + condition(depth - 1);
    case 3: return "(" + condition(depth - 1) + ")";
    case 4: return condition(depth - 1) + " and " + condition(0) + " or " + condition(0);
    default: return condition(0) + " or " + condition(0) + " and not " + condition(0);
    }
  }

  std::string comparison() {
    if (random.chance(5)) return random.chance(50) ? "true" : "false";
    const auto resource = random.below(states.size());
    return fmt::format("r{} {} {}", resource,
                       random.chance(60) ? "==" : "!=", state(random.below(states[resource])));
  }

  RandomSource random;
  std::vector<std::size_t> states; ///< number by resource
};

} // namespace

std::string randomSkillset(std::uint64_t seed) { return Writer(seed).skillset(); }

} // namespace proskill::test
