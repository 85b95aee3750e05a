#include "ide/verdicts/waits.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string_view>
#include <utility>

namespace proskill::ide {

namespace {

constexpr std::size_t kMost = 4;

/// How descriptions of steps begin, and how the waits for these steps do.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kBeginnings{{
    {"has waited ", "waits "},
    {"continues after ", "waits for the end of "},
    {"joins ", "waits for the end of "},
    {"notices that ", "waits until "},
}};

/// "`m` waits for the end of `drive`", from the step "m continues after `drive`".
std::string waitText(const fiacre::Origin& next) {
  const std::string_view step = next.description;
  for (const auto& [beginning, wait] : kBeginnings)
    if (step.starts_with(beginning))
      return fmt::format("`{}` {}{}", next.actor, wait, step.substr(beginning.size()));
  return fmt::format("`{}` waits until it {}", next.actor, step);
}

using fiacre::Ground;

/// ", which `brush` and `scan` have"; empty if nobody has the resource.
std::string holdersText(const verify::Wait& wait, const fiacre::Origin& next,
                        const std::string& resource) {
  std::vector<std::string> holders;
  for (const auto index : wait.grounds) {
    const auto& ground = next.grounds[index];
    if (ground.kind == Ground::Kind::Holder && ground.variable == resource)
      holders.push_back("`" + ground.text + "`");
  }
  if (holders.empty()) return {};
  return fmt::format(", which {} {}", fmt::join(holders, " and "),
                     holders.size() == 1 ? "has" : "have");
}

/// "`drive` waits for the resource `wheels`, which `brush` has": a skill that cannot start.
std::string needText(const verify::Wait& wait, const fiacre::Origin& next) {
  std::vector<std::string> needs;
  for (const auto index : wait.grounds)
    if (const auto& ground = next.grounds[index]; ground.kind == Ground::Kind::Need)
      needs.push_back(ground.text + (ground.variable.empty()
                                         ? std::string()
                                         : holdersText(wait, next, ground.variable)));
  return fmt::format("`{}` waits for {}", next.actor, fmt::join(needs, ", and for "));
}

} // namespace

std::string waitsText(const std::vector<verify::Wait>& waits, const codegen::Model& model) {
  std::string text;
  for (std::size_t i = 0; i < waits.size() && i < kMost; ++i) {
    const auto& next = model.provenance.origins[waits[i].origin];
    text += i == 0 ? "" : "; ";
    text += waits[i].grounds.empty() ? waitText(next) : needText(waits[i], next);
  }
  if (waits.size() > kMost) text += fmt::format("; and {} more", waits.size() - kMost);
  return text;
}

} // namespace proskill::ide
