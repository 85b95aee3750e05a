#include "tests/groot/watched_run.h"
#include "tests/support/random/random_program.h"
#include "verify/state/evaluate.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace proskill;
using groot::Status;
using test::WatchedRun;

namespace {

constexpr auto kRunning = static_cast<std::uint8_t>(Status::Running);

/// The nodes at which processes are, by block. One that is stopped stays where it was.
class Places {
public:
  explicit Places(const WatchedRun& of) : it(of), last(of.executable->system.cells.size()) {}

  std::set<std::string> in(const std::vector<verify::Word>& state) {
    std::set<std::string> all;
    for (const auto& process : groot::processesOf(it.tree, *it.executable)) {
      const auto at = verify::readCell(it.executable->system, process.location, state.data());
      const auto& stand = process.stands[static_cast<std::size_t>(at)];
      auto& node = last[process.location];
      if (!stand.isStopped) node = stand.node;
      if (node) all.insert(fmt::format("{} {}", process.block, *node));
    }
    return all;
  }

  /// Whether a process is where the state alone does not say at which node it was.
  [[nodiscard]] bool isStopped(const std::vector<verify::Word>& state) const {
    const auto all = groot::processesOf(it.tree, *it.executable);
    return std::ranges::any_of(all, [&](const groot::Process& process) {
      const auto at = verify::readCell(it.executable->system, process.location, state.data());
      return process.stands[static_cast<std::size_t>(at)].isStopped;
    });
  }

private:
  const WatchedRun& it;
  std::vector<std::optional<groot::NodeIndex>> last; ///< by the cell of a process
};

/// The innermost nodes that run, by block, and those that run below one that does not.
std::set<std::string> running(const WatchedRun& it, const groot::Statuses& statuses) {
  std::set<std::string> all;
  for (const auto& instance : it.tree.instances) {
    const auto& nodes = it.tree.blockOf(instance).nodes;
    if (!it.tree.blockOf(instance).skill) continue;
    const auto runs = [&](groot::NodeIndex node) {
      return statuses.bytes()[instance.uid(node) - 1U] == kRunning;
    };
    for (groot::NodeIndex i = 0; i < nodes.size(); ++i) {
      if (!runs(i)) continue;
      if (!runs(nodes[i].parent)) all.insert(fmt::format("below {}", instance.uid(i)));
      bool isInnermost = true;
      for (auto below = i + 1; below < nodes[i].end; ++below)
        isInnermost = isInnermost && !runs(below);
      if (i == 0) continue; // also runs after the last statement
      if (isInnermost || nodes[i].kind == groot::NodeKind::Parallel)
        all.insert(fmt::format("{} {}", instance.block, i));
    }
  }
  return all;
}

/// Calls a function with each random program that can be watched, and its seed.
template <class Use> void eachRandomTree(Use use) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto text =
        test::textOf(test::randomProgram(seed, test::varied(seed, {.properties = 0})));
    if (!WatchedRun::isPossible(text)) continue;
    WatchedRun it(text);
    INFO("seed " << seed << "\n" << text << groot::xmlOf(it.tree));
    use(it, seed);
  }
}

} // namespace

TEST_CASE("in runs of random programs those nodes run at which the processes are") {
  std::size_t steps = 0;
  std::size_t trees = 0;
  eachRandomTree([&](WatchedRun& it, std::uint64_t seed) {
    trees += it.tree.instances.size();
    std::set<std::string> wrong;
    Places places(it);
    const auto check = [&](const groot::Statuses& statuses, auto date, const auto& state) {
      ++steps;
      const auto run = running(it, statuses);
      const auto expected = places.in(state);
      if (wrong.empty() && run != expected) {
        wrong = run;
        INFO("at " << date);
        CHECK(run == expected);
      }
    };
    it.run(check, seed, "", 30);
  });
  CHECK(steps > 3'000);
  CHECK(trees > 400);
}

TEST_CASE("after steps that are not known those nodes run at which the processes are") {
  std::size_t compared = 0;
  eachRandomTree([&](WatchedRun& it, std::uint64_t seed) {
    Places places(it);
    groot::Statuses jumping(it.tree, *it.executable, [](auto, auto) {});
    std::size_t steps = 0;
    const auto check = [&](const groot::Statuses&, auto date, const auto& state) {
      const auto expected = places.in(state);
      if (++steps % 5 != 0) return;
      jumping.jump(state.data());
      if (places.isStopped(state)) return;
      ++compared;
      INFO("at " << date);
      CHECK(running(it, jumping) == expected);
    };
    it.run(check, seed, "", 30);
  });
  CHECK(compared > 500);
}

TEST_CASE("a call has the status of what it calls, a call that is refused is skipped") {
  WatchedRun it(R"(
    (defsv x :states (A B) :init A :transitions :all)
    (defskill fly :precondition (b (x B)) :action (fly) :success there :failure lost)
    (defskill try :success well :failure badly
      :body ((fly) (if (= fly.status success) (success well)) (failure badly)))
    (defskill mission :body ((try) (set (x B)) (try) (try))))");
  const auto* script = R"({"actions": {"fly": [{"result": "there", "after": 2},
                                               {"result": "lost", "after": 1}]}, "signals": []})";
  CHECK(it.changesOf("try", script) == "0 2 running\n0 2 failure\n0 4 running\n2 4 success\n"
                                       "2 5 running\n3 5 failure\n3 2 idle\n3 4 idle\n3 5 idle\n");
  CHECK(it.changesOf("fly", script) ==
        "0 7 running\n0 7 skipped\n0 7 idle\n0 13 running\n2 13 success\n2 13 idle\n"
        "2 19 running\n3 19 failure\n3 19 idle\n");
}

TEST_CASE("tests have results, and nodes that are repeated begin again") {
  WatchedRun it(R"(
    (defsv n :min 0 :max 3 :init 0)
    (defskill mission :body (
      (while (< n 2) (set (n (+ n 1))) (^ 1))
      (if (= n 0) (^ 5) elseif (= n 2) (^ 3) else (^ 7)))))");
  CHECK(it.changesOf("Test") == "0 4 running\n0 4 success\n1 4 idle\n1 4 running\n1 4 success\n"
                                "2 4 idle\n2 4 running\n2 4 failure\n2 4 idle\n"
                                "2 9 running\n2 9 failure\n2 12 success\n5 12 idle\n5 9 idle\n");
  CHECK(it.changesOf("WaitFor") == "0 7 running\n1 7 success\n1 7 idle\n1 7 running\n2 7 success\n"
                                   "2 7 idle\n2 13 running\n5 13 success\n5 13 idle\n");
}

TEST_CASE("what a race or an interrupt stops is idle, a wait that is too long has failed") {
  WatchedRun it(R"(
    (defsv x :states (A B) :init A :transitions :all)
    (defskill fly :action (fly) :interrupt () :success there)
    (defskill patrol :interrupt () :body ((fly) (fly)))
    (defskill mission :success s :body (
      (^ (x B) :timeout 1 (printf "late"))
      (race ((patrol)) ((^ 2)))
      (// ((patrol)) ((^ 4) (patrol.interrupt)))
      (success s))))");
  const auto* script = R"({"actions": {"fly": [{"result": "there", "after": 10}]}, "signals": []})";
  CHECK(it.changesOf("WaitUntil", script) == "0 3 running\n1 3 failure\n1 3 idle\n");
  CHECK(it.changesOf("fly", script).starts_with("1 15 running\n3 15 idle\n3 18 running\n"));
  CHECK(it.changesOf("Succeed", script).ends_with(" 13 running\n7 13 success\n7 13 idle\n"));
}

TEST_CASE("a skill that two call at once is shown below the one whose call it performs") {
  WatchedRun it(R"(
    (defskill fly :action (fly) :success there)
    (defskill search :body ((fly)))
    (defskill mission :body ((// ((search)) ((search))))))");
  const auto* script = R"({"actions": {"fly": [{"result": "there", "after": 2},
                                               {"result": "there", "after": 3}]}, "signals": []})";
  CHECK(it.tagged("fly") == std::vector<groot::Uid>{6, 8});
  CHECK(it.changesOf("fly", script) == "0 8 running\n2 8 success\n2 8 idle\n"
                                       "2 6 running\n5 6 success\n5 6 idle\n");
}

TEST_CASE("a mission whose invariant fails has failed, and what it did is idle") {
  WatchedRun it(R"(
    (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
    (defevent storm :effects (sky Stormy))
    (defskill fly :action (fly) :interrupt () :success there)
    (defskill mission :invariant (calm (:guard (sky Clear))) :body ((fly) (fly))))");
  std::vector<std::uint8_t> last;
  const auto result = it.run([&](const groot::Statuses& statuses, runtime::Nanoseconds,
                                 const auto&) { last = statuses.bytes(); },
                             0, R"({"actions": {"fly": [{"result": "there", "after": 9}]},
                    "signals": [{"at": 4, "event": "storm"}]})");
  CHECK(result.missionStatus == "failed_inv");
  CHECK(last == std::vector<std::uint8_t>{3, 11, 0});
}
