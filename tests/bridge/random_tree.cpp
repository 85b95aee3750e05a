#include "tests/bridge/random_tree.h"

#include <fmt/format.h>

namespace proskill::test {
namespace {

class Grower {
public:
  explicit Grower(std::uint64_t seed) : random(seed) {}

  std::string node(int depth) {
    ++count;
    if (depth == 0 || count > 12 || random.chance(25)) return leaf();
    switch (random.below(14)) {
    case 0:
    case 1: return several(random.chance(75) ? "Sequence" : "SequenceWithMemory", "", depth);
    case 2: return several("Fallback", "", depth);
    case 3:
    case 4: return reactive(depth);
    case 5: return parallel(depth);
    case 6: return choice(depth);
    case 7: return ofNav2(depth);
    case 8: return rare(depth);
    case 9:
    case 10: return withScript(node(depth));
    default: return decorator(depth);
    }
  }

private:
  std::string element(const std::string& head, const std::string& inner) {
    const auto name = head.substr(0, head.find(' '));
    return "<" + head + ">" + inner + "</" + name + ">\n";
  }

  std::string leaf() {
    const auto kind = random.below(12);
    if (kind < 6 && actions < 4) return action();
    if (kind < 10) return condition();
    return random.pick<std::string>({"<AlwaysSuccess/>\n", "<AlwaysFailure/>\n",
                                     inTimeout > 0 ? condition() : "<Sleep msec=\"1000\"/>\n"});
  }

  std::string condition() { return fmt::format("<Condition ID=\"c{}\"/>\n", random.below(3)); }

  std::string action() {
    const auto type = random.pick<std::string>({"Any", "Any", "Any", "Good", "Bad", "Quick"});
    return fmt::format("<Action ID=\"{}\" name=\"a{}\"/>\n", type, actions++);
  }

  std::string children(std::size_t number, int depth) {
    std::string text;
    for (std::size_t i = 0; i < number; ++i) text += node(depth - 1);
    return text;
  }

  /// A script decides about a node.
  std::string withScript(std::string node) {
    const auto script =
        random.pick<std::string>({"_skipIf", "_skipIf", "_while", "_failureIf", "_successIf"});
    if (!node.substr(0, node.find('>')).contains(script))
      node.insert(node.find_first_of(" />", 1), " " + script + "=\"x\"");
    return node;
  }

  std::string rare(int depth) {
    switch (random.below(5)) {
    case 0:
      return element(random.chance(60) ? "RunOnce" : "RunOnce then_skip=\"false\"",
                     node(depth - 1));
    case 1: return element("SkipUnlessUpdated entry=\"{x}\"", node(depth - 1));
    case 2: {
      const auto otherwise = random.pick<std::string>({"SUCCESS", "FAILURE", "SKIPPED", "RUNNING"});
      return element("Precondition if=\"x\" else=\"" + otherwise + "\"", node(depth - 1));
    }
    case 3: {
      const auto elements = random.pick<std::string>({"1", "1;2", "1;2;3", "{queue}"});
      const auto otherwise = random.pick<std::string>({"SUCCESS", "SUCCESS", "FAILURE", "SKIPPED"});
      return element("LoopInt queue=\"" + elements + "\" if_empty=\"" + otherwise + "\"",
                     node(depth - 1));
    }
    default: return element("TryCatch", children(2 + random.below(2), depth));
    }
  }

  /// Any child but the first may be skipped.
  std::string several(const std::string& tag, const std::string& ports, int depth) {
    auto text = node(depth - 1);
    for (std::size_t more = random.below(3); more > 0; --more) {
      auto child = node(depth - 1);
      text += random.chance(25) ? withScript(child) : child;
    }
    return element(tag + ports, text);
  }

  /// Mostly conditions first, then what may run, which may be several children.
  std::string reactive(int depth) {
    std::string text;
    for (std::size_t i = random.below(3); i > 0; --i) text += guard();
    text += node(depth - 1);
    for (std::size_t i = random.below(2); i > 0; --i) text += guard();
    if (random.chance(25)) text += node(depth - 1);
    return element(random.chance(50) ? "ReactiveSequence" : "ReactiveFallback", text);
  }

  std::string guard() {
    if (random.chance(60)) return condition();
    if (random.chance(50)) return element("Inverter", condition());
    return element(random.chance(50) ? "Sequence" : "Fallback", condition() + guard());
  }

  std::string parallel(int depth) {
    const auto number = 1 + random.below(3);
    if (random.chance(30))
      return element(fmt::format("ParallelAll max_failures=\"{}\"", 1 + random.below(number)),
                     children(number, depth));
    return element(fmt::format("Parallel success_count=\"{}\" failure_count=\"{}\"",
                               1 + random.below(number), 1 + random.below(number)),
                   children(number, depth));
  }

  std::string choice(int depth) {
    const auto number = 1 + random.below(2);
    if (random.chance(40)) return element("IfThenElse", node(depth - 1) + children(number, depth));
    if (random.chance(60)) return element("WhileDoElse", guard() + children(number, depth));
    return element("Switch2 variable=\"{x}\" case_1=\"1\" case_2=\"2\"", children(3, depth));
  }

  std::string ofNav2(int depth) {
    const auto number = 1 + random.below(3);
    switch (random.below(8)) {
    case 4: return element("PersistentSequence", children(number, depth));
    case 5: return element("NonblockingSequence", children(number, depth));
    case 6: return element("PauseResumeController", children(1 + random.below(4), depth));
    case 7: return element("Mine", children(1 + random.below(2), depth));
    case 0: return element("RoundRobin", children(number, depth));
    case 1: return element("PipelineSequence", children(number, depth));
    case 2: return element("RateController hz=\"1\"", node(depth - 1));
    default:
      return element(fmt::format("RecoveryNode number_of_retries=\"{}\"", random.below(3)),
                     children(2, depth));
    }
  }

  std::string decorator(int depth) {
    if (random.chance(12)) return timeout(depth);
    const auto rounds = random.pick<std::string>({"-1", "1", "2", "3"});
    const auto tag = random.pick<std::string>(
        {"Inverter", "ForceSuccess", "ForceFailure", "Repeat num_cycles=\"" + rounds + "\"",
         "RetryUntilSuccessful num_attempts=\"" + rounds + "\"", "KeepRunningUntilFailure",
         inTimeout > 0 ? "Inverter" : "Delay delay_msec=\"1000\""});
    return element(tag, node(depth - 1));
  }

  /// Without other fixed times in it: the ticker does not compare times.
  std::string timeout(int depth) {
    ++inTimeout;
    const auto child = node(depth - 1);
    --inTimeout;
    return element("Timeout msec=\"1000000\"", child);
  }

  RandomSource random;
  int count = 0;
  int actions = 0;
  int inTimeout = 0;
};

} // namespace

std::string randomTree(std::uint64_t seed) {
  return "<root BTCPP_format=\"4\">\n<BehaviorTree ID=\"Main\">\n" + Grower(seed).node(4) +
         "</BehaviorTree>\n</root>\n";
}

} // namespace proskill::test
