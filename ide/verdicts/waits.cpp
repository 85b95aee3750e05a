#include "ide/verdicts/waits.h"

#include <fmt/format.h>

namespace proskill::ide {

namespace {

constexpr std::size_t kMost = 4;

/// The wait for a step, from the step's description: "has waited for `(door Open)`", "`drive`
/// returns".
std::string waitText(const fiacre::Origin& next) {
  constexpr std::string_view kPast = "has waited ";
  const std::string_view step = next.description;
  if (step.starts_with(kPast))
    return fmt::format("`{}` waits {}", next.actor, step.substr(kPast.size()));
  return fmt::format("`{}` waits until {}", next.actor, step);
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
