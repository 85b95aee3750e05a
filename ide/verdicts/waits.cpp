#include "ide/verdicts/waits.h"

#include <fmt/format.h>

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

} // namespace

std::string waitsText(const std::vector<fiacre::OriginId>& waits, const codegen::Model& model) {
  std::string text;
  for (std::size_t i = 0; i < waits.size() && i < kMost; ++i)
    text += (i == 0 ? "" : "; ") + waitText(model.provenance.origins[waits[i]]);
  if (waits.size() > kMost) text += fmt::format("; and {} more", waits.size() - kMost);
  return text;
}

} // namespace proskill::ide
