#include "groot/statuses.h"

#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::groot {

namespace {

constexpr std::uint8_t kWas = 10; ///< is added to the status that an idle node had before

} // namespace

Statuses::Statuses(const Tree& of, const runtime::Executable& executable, Changed to)
    : tree(of),
      system(executable.system),
      changed(std::move(to)),
      outcomes(outcomesOf(executable)),
      processes(processesOf(of, executable)),
      active(of.blocks.size(), kNoInstance),
      now(of.size(), 0) {
  follow(verify::initialState(system).data());
}

void Statuses::follow(const verify::Word* after) {
  state = after;
  for (auto& process : processes) {
    const auto to = static_cast<std::size_t>(verify::readCell(system, process.location, state));
    if (process.at == to) continue;
    const auto from = process.stand();
    process.at = to;
    move(process, from);
  }
  state = nullptr;
}

void Statuses::jump(const verify::Word* after) {
  for (auto& process : processes) process.at.reset();
  std::ranges::fill(active, kNoInstance);
  for (std::size_t i = 0; i < now.size(); ++i) set(static_cast<Uid>(i + 1), Status::Idle);
  follow(after);
}

void Statuses::move(const Process& process, const Process::Stand& from) {
  const auto to = process.stand();
  if (to.node) return from.node ? advance(process, *from.node, *to.node) : begin(process, *to.node);
  if (to.isStopped) return; // what it has called may still run
  if (from.node) finish(process, *from.node);
  if (!to.isDone || from.isDone) return;
  if (!process.branch) return complete(process);
  if (from.isStopped) halt(process);
}

/// The body or the branch starts.
void Statuses::begin(const Process& process, NodeIndex node) {
  auto& instance = active[process.block];
  if (!process.branch || instance == kNoInstance) instance = calledInstance(process.block);
  const auto at = placeOf(process);
  rest(at, process.top(), at.block.nodes[process.top()].end);
  if (!process.branch) tellProgram(at, Status::Running);
  run(at, node);
}

/// The body or the branch has come to its end.
void Statuses::finish(const Process& process, NodeIndex from) {
  const auto at = placeOf(process);
  leave(at, from, std::nullopt);
  const bool fails = at.block.nodes[from].kind == NodeKind::Failing;
  for (auto node = from; node != process.top();) {
    node = at.block.nodes[node].parent;
    if (node != 0) end(at, node, fails ? Status::Failure : Status::Success);
  }
}

/// The skill has ended.
void Statuses::complete(const Process& process) {
  const auto at = placeOf(process);
  const auto outcome = outcomeOf(at.block.name);
  end(at, 0, outcome);
  tellProgram(at, outcome);
}

/// The branch has been stopped.
void Statuses::halt(const Process& process) {
  const auto at = placeOf(process);
  rest(at, process.top(), at.block.nodes[process.top()].end);
}

void Statuses::advance(const Process& process, NodeIndex from, NodeIndex to) {
  if (from == to) return;
  const auto at = placeOf(process);
  const auto& nodes = at.block.nodes;
  leave(at, from, to);
  auto common = from;
  for (; !at.block.contains(common, to); common = nodes[common].parent)
    if (common != from) end(at, common, Status::Success);
  if (to <= from) rest(at, std::max(to, common + 1), nodes[common].end); // another round
  run(at, to);
}

void Statuses::leave(const Place& at, NodeIndex from, std::optional<NodeIndex> to) {
  const auto& node = at.block.nodes[from];
  switch (node.kind) {
  case NodeKind::Test: return decide(at, from, to);
  case NodeKind::Call: return end(at, from, outcomeOf(node.skill));
  case NodeKind::SubTree: {
    const auto below = tree.below.at({at.instance, from});
    const auto& callee = tree.instances[below];
    rest({tree.blockOf(callee), below, callee}, 0, tree.blockOf(callee).nodes.front().end);
    return end(at, from, outcomeOf(node.skill));
  }
  case NodeKind::Timed: {
    const bool isLate = to && *to > from && at.block.contains(node.parent, *to);
    return end(at, from, isLate ? Status::Failure : Status::Success);
  }
  case NodeKind::Failing: return end(at, from, Status::Failure);
  case NodeKind::Control: // chooses one of its children
    if (to && at.block.contains(from, *to)) return;
    return end(at, from, Status::Success);
  case NodeKind::Parallel:
  case NodeKind::Choice:
  case NodeKind::Loop:
  case NodeKind::Leaf: return end(at, from, Status::Success);
  }
}

/// The result of a test, and of those that are tested with it, by where the process goes.
void Statuses::decide(const Place& at, NodeIndex test, std::optional<NodeIndex> to) {
  const auto& nodes = at.block.nodes;
  const auto isIn = [&](NodeIndex node) { return to && at.block.contains(node, *to); };
  const auto parent = nodes[test].parent;
  if (nodes[parent].kind != NodeKind::Choice) {
    const bool isFirst = test == parent + 1;
    return end(at, test, isIn(parent) == isFirst ? Status::Success : Status::Failure);
  }
  const bool holds = isIn(test + 1);
  end(at, test, holds ? Status::Success : Status::Failure);
  const auto otherwise = nodes[test + 1].end;
  if (holds || otherwise == nodes[parent].end) return;
  // the conditions of an `elseif` are tested at the first one; an `if` has a place of its own
  const bool isElseif = nodes[otherwise].kind == NodeKind::Choice && to != otherwise + 1;
  if (!isElseif) return;
  run(at, otherwise);
  decide(at, otherwise + 1, to);
}

void Statuses::tellProgram(const Place& at, Status status) {
  if (at.in.parent == kNoInstance) return;
  const auto& caller = tree.instances[at.in.parent];
  if (tree.blockOf(caller).skill) return; // its node has the status of the call
  const Place program{tree.blockOf(caller), at.in.parent, caller};
  if (status == Status::Running) return run(program, at.in.call);
  end(program, at.in.call, status);
  if (at.instance == tree.mission) set(caller.uid(0), status);
}

Statuses::Place Statuses::placeOf(const Process& process) const {
  const auto instance = active[process.block];
  return {tree.blocks[process.block], instance, tree.instances[instance]};
}

/// The instance of a skill that starts: the one whose call waits for it.
std::uint32_t Statuses::calledInstance(std::uint32_t block) const {
  std::uint32_t any = kNoInstance;
  for (std::uint32_t i = 0; i < tree.instances.size(); ++i) {
    const auto& instance = tree.instances[i];
    if (instance.block != block) continue;
    if (isCalled(instance)) return i;
    any = std::min(any, i);
  }
  return any;
}

bool Statuses::isCalled(const Instance& instance) const {
  if (instance.parent == kNoInstance) return true;
  const auto caller = tree.instances[instance.parent].block;
  return active[caller] == instance.parent &&
         std::ranges::any_of(processes, [&](const Process& process) {
           const auto stand = process.stand();
           return process.block == caller && stand.node == instance.call && stand.hasCalled;
         });
}

Status Statuses::outcomeOf(std::string_view skill) const {
  const auto found = outcomes.find(skill);
  if (found == outcomes.end()) return Status::Success;
  const auto& [cell, statuses] = found->second;
  const auto value = verify::readCell(system, cell, state) - system.cells[cell].low;
  return statuses.at(static_cast<std::size_t>(value));
}

void Statuses::run(const Place& at, NodeIndex node) {
  if (node != 0) run(at, at.block.nodes[node].parent);
  set(at.in.uid(node), Status::Running);
}

void Statuses::end(const Place& at, NodeIndex node, Status status) {
  rest(at, node + 1, at.block.nodes[node].end);
  set(at.in.uid(node), status);
}

void Statuses::rest(const Place& at, NodeIndex first, NodeIndex last) {
  for (auto node = first; node < last; ++node) set(at.in.uid(node), Status::Idle);
}

void Statuses::set(Uid uid, Status status) {
  auto& byte = now[uid - 1U];
  const auto was = byte < kWas ? byte : 0;
  const auto is = static_cast<std::uint8_t>(status);
  if (was == is) return;
  byte = status == Status::Idle ? static_cast<std::uint8_t>(kWas + was) : is;
  changed(uid, status);
}

} // namespace proskill::groot
