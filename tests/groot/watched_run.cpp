#include "tests/groot/watched_run.h"

#include "runtime/platform/settings.h"
#include "runtime/platform/simulated.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace proskill::test {

namespace {

std::unique_ptr<const runtime::Executable> madeOf(const analysis::Program& program,
                                                  bool environment) {
  auto made = runtime::makeExecutable(program, "", environment);
  REQUIRE(made);
  return std::move(*made);
}

constexpr const char* kWords[] = {"idle", "running", "success", "failure", "skipped"};

} // namespace

runtime::RunResult execute(const runtime::Executable& executable, runtime::Observer& observer,
                           std::uint64_t seed, const std::string& script, double until) {
  auto settings = runtime::defaultSettings(executable);
  if (!script.empty())
    REQUIRE(
        runtime::readScript(runtime::JsonFile::parse(script).value(), executable.model, settings)
            .empty());
  const auto platform = runtime::simulatedPlatform(std::move(settings), seed + 1);
  const auto clock = runtime::simulatedClock();
  runtime::RunOptions options{.seed = seed, .mostAtOnce = 2'000};
  options.until = static_cast<runtime::Nanoseconds>(until * runtime::kSecond);
  return runtime::execute(executable, *clock, *platform, observer, options);
}

WatchedRun::WatchedRun(const std::string& text)
    : program(programOfText(text)), executable(madeOf(program, true)) {
  INFO(text);
  REQUIRE(isWellFormed(program));
  auto made = groot::treeOf(program, *executable);
  REQUIRE(made);
  tree = std::move(*made);
}

bool WatchedRun::isPossible(const std::string& text) {
  const auto program = programOfText(text);
  return groot::treeOf(program, *madeOf(program, true)).has_value();
}

runtime::RunResult WatchedRun::run(const AfterStep& afterStep, std::uint64_t seed,
                                   const std::string& script, double until) {
  groot::Statuses statuses(tree, *executable, [](groot::Uid, groot::Status) {});
  Watcher watcher([&](const runtime::Machine& machine, runtime::Nanoseconds date) {
    statuses.follow(machine.state().data());
    afterStep(statuses, date, machine.state());
  });
  return execute(*executable, watcher, seed, script, until);
}

std::vector<groot::Uid> WatchedRun::tagged(std::string_view tag) const {
  std::vector<groot::Uid> all;
  for (const auto& instance : tree.instances)
    for (groot::NodeIndex i = 0; i < tree.blockOf(instance).nodes.size(); ++i) {
      const auto& node = tree.blockOf(instance).nodes[i];
      if (node.tag == tag || (node.kind == groot::NodeKind::SubTree && node.skill == tag))
        all.push_back(instance.uid(i));
    }
  return all;
}

std::string WatchedRun::changesOf(std::string_view tag, const std::string& script) {
  const auto uids = tagged(tag);
  REQUIRE(!uids.empty());
  std::string text;
  runtime::Nanoseconds now = 0;
  groot::Statuses statuses(tree, *executable, [&](groot::Uid uid, groot::Status status) {
    if (std::ranges::find(uids, uid) == uids.end()) return;
    text += fmt::format("{} {} {}\n", static_cast<double>(now) / runtime::kSecond, uid,
                        kWords[static_cast<std::size_t>(status)]);
  });
  Watcher watcher([&](const runtime::Machine& machine, runtime::Nanoseconds date) {
    now = date;
    statuses.follow(machine.state().data());
  });
  execute(*executable, watcher, 0, script);
  return text;
}

} // namespace proskill::test
