#include "verify/guide/plan_progress.h"

#include <algorithm>
#include <cstddef>

namespace proskill::verify {

namespace {

// Places in what is kept of a node.
constexpr std::size_t kLeft = 0;
constexpr std::size_t kEvents = 1;
constexpr std::size_t kRoles = 2;

} // namespace

PlanProgress::PlanProgress(const System& of, const std::vector<TransitionId>& plan)
    : system(of), roleOf(of.instances.size(), kNone) {
  for (auto step : plan) {
    if (isEvent(step)) {
      Event event{step, {}};
      for (const auto& steps : roles)
        event.after.push_back(static_cast<std::uint32_t>(steps.size()));
      events.push_back(std::move(event));
    }
    for (auto part : system.transitions[step].parts)
      if (moves(part)) roles[roleFor(system.paths[part].instance)].push_back(step);
  }
  width = kRoles + roles.size();
}

/// Whether the instance of the path has several locations.
bool PlanProgress::moves(PathId path) const {
  return system.instances[system.paths[path].instance].locations.size() > 1;
}

bool PlanProgress::isEvent(TransitionId step) const {
  return std::ranges::none_of(system.transitions[step].parts,
                              [this](PathId part) { return moves(part); });
}

PlanProgress::RoleId PlanProgress::roleFor(InstanceId instance) {
  if (roleOf[instance] == kNone) {
    roleOf[instance] = static_cast<RoleId>(roles.size());
    roles.emplace_back();
  }
  return roleOf[instance];
}

std::uint32_t PlanProgress::add(std::span<const TransitionId> steps) {
  const auto first = kept.size();
  kept.resize(first + width);
  std::uint32_t* node = kept.data() + first;
  if (expanded != kNone) {
    std::copy_n(kept.data() + expanded * width, width, node);
  } else {
    node[kLeft] = static_cast<std::uint32_t>(events.size());
    for (const auto& role : roles) node[kLeft] += static_cast<std::uint32_t>(role.size());
  }
  for (auto step : steps) follow(step, node);
  return node[kLeft];
}

void PlanProgress::follow(TransitionId step, std::uint32_t* node) const {
  if (isEvent(step)) return followEvent(step, node);
  for (auto part : system.transitions[step].parts) {
    const RoleId role = roleOf[system.paths[part].instance];
    if (role == kNone) continue;
    auto& place = node[kRoles + role];
    const bool isPlanned = place < roles[role].size() && roles[role][place] == step;
    if (isPlanned) ++place;
    node[kLeft] += isPlanned ? -1U : 1U;
  }
}

/// An event that the plan needs later is one that was taken instead.
void PlanProgress::followEvent(TransitionId step, std::uint32_t* node) const {
  auto& happened = node[kEvents];
  if (happened < events.size() && events[happened].step == step &&
      isTime(events[happened], node + kRoles)) {
    ++happened;
    --node[kLeft];
  } else if (std::any_of(events.begin() + happened, events.end(),
                         [&](const Event& it) { return it.step == step; })) {
    ++node[kLeft];
  }
}

bool PlanProgress::isTime(const Event& event, const std::uint32_t* places) const {
  for (RoleId i = 0; i < event.after.size(); ++i)
    if (places[i] < event.after[i]) return false;
  return true;
}

} // namespace proskill::verify
