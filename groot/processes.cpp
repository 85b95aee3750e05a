#include "groot/processes.h"

namespace proskill::groot {

namespace {

constexpr std::string_view kStatusOf = ".status";

Status statusOf(std::string_view word) {
  if (word == "success") return Status::Success;
  // as after a call that was refused
  return word == "no_status" ? Status::Skipped : Status::Failure;
}

/// The node of a branch that contains this one, if it is in a branch.
std::optional<NodeIndex> branchOf(const Block& block, NodeIndex node) {
  for (; node != 0; node = block.nodes[node].parent)
    if (block.nodes[block.nodes[node].parent].kind == NodeKind::Parallel) return node;
  return std::nullopt;
}

/// The process as one of the block's, if it is ever at one of its statements.
std::optional<Process> processOf(const Block& block, const verify::Instance& instance,
                                 const fiacre::Provenance& provenance) {
  if (!block.skill) return std::nullopt;
  Process process{.location = instance.location};
  std::optional<NodeIndex> any;
  for (std::size_t i = 0; i < instance.locations.size(); ++i) {
    const auto& origin = provenance.origins[instance.locationOrigins[i]];
    const auto found = block.at.find({origin.begin, origin.end});
    auto& stand = process.stands.emplace_back();
    if (origin.file == block.skill->file && found != block.at.end())
      any = stand.node = found->second;
    // the names that the generator gives to these states
    stand.isStopped = instance.locations[i].starts_with("stopping");
    stand.isDone = instance.locations[i] == "idle" || instance.locations[i] == "ended";
    stand.hasCalled = instance.locations[i].ends_with("_sync");
  }
  if (!any) return std::nullopt;
  process.branch = branchOf(block, *any);
  return process;
}

} // namespace

std::vector<Process> processesOf(const Tree& tree, const runtime::Executable& executable) {
  std::vector<Process> all;
  for (std::uint32_t i = 0; i < tree.blocks.size(); ++i)
    for (const auto& instance : executable.system.instances)
      if (auto process = processOf(tree.blocks[i], instance, executable.model.provenance)) {
        process->block = i;
        all.push_back(std::move(*process));
      }
  return all;
}

std::map<std::string, Outcome, std::less<>> outcomesOf(const runtime::Executable& executable) {
  std::map<std::string, Outcome, std::less<>> all;
  for (const auto& watched : executable.system.watched) {
    const std::string_view name = watched.display;
    if (!name.ends_with(kStatusOf)) continue;
    auto& outcome = all[std::string(name.substr(0, name.size() - kStatusOf.size()))];
    outcome.cell = watched.cell;
    for (const auto& word : watched.words) outcome.statuses.push_back(statusOf(word));
  }
  return all;
}

} // namespace proskill::groot
