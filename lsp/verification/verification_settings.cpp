#include "lsp/verification/verification_settings.h"

#include <algorithm>

namespace proskill::lsp {

namespace {

constexpr double kMostSeconds = 86'400 * 30.0;
constexpr std::uint64_t kMostMegabytes = std::uint64_t{1} << 24;

const Json* member(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

void readFlag(const Json& object, const char* name, bool& value) {
  if (const auto* json = member(object, name); json && json->is_boolean())
    value = json->get<bool>();
}

void readSeconds(const Json& object, const char* name, double& value) {
  const auto* json = member(object, name);
  if (json && json->is_number() && json->get<double>() > 0)
    value = std::min(json->get<double>(), kMostSeconds);
}

void readMegabytes(const Json& object, const char* name, std::uint64_t& value) {
  const auto* json = member(object, name);
  if (json && json->is_number_unsigned() && json->get<std::uint64_t>() > 0)
    value = std::min(json->get<std::uint64_t>(), kMostMegabytes);
}

} // namespace

std::chrono::steady_clock::duration
delayAfter(const VerificationSettings& settings,
           std::optional<std::chrono::steady_clock::duration> took) {
  const std::chrono::steady_clock::duration most = settings.delay;
  return took ? std::min(most, *took / 2) : most;
}

VerificationSettings withSettings(VerificationSettings settings, const Json& section) {
  readFlag(section, "live", settings.live);
  readFlag(section, "durations", settings.durations);
  readSeconds(section, "seconds", settings.liveBudget.seconds);
  readMegabytes(section, "megabytes", settings.liveBudget.megabytes);
  readSeconds(section, "requestSeconds", settings.requestBudget.seconds);
  readMegabytes(section, "requestMegabytes", settings.requestBudget.megabytes);
  if (const auto* delay = member(section, "delay"); delay && delay->is_number_unsigned())
    settings.delay =
        std::chrono::milliseconds(std::min<std::uint64_t>(delay->get<std::uint64_t>(), 3'600'000));
  return settings;
}

VerificationSettings initialSettings(const Json& options) {
  VerificationSettings settings;
  readFlag(options, "trusted", settings.trusted);
  if (const auto* section = member(options, "verify")) return withSettings(settings, *section);
  return settings;
}

worker::Budget withLimits(worker::Budget budget, const Json& limits) {
  readSeconds(limits, "seconds", budget.seconds);
  readMegabytes(limits, "megabytes", budget.megabytes);
  if (const auto* classes = member(limits, "classes"); classes && classes->is_number_unsigned())
    budget.classes = classes->get<std::uint64_t>();
  return budget;
}

} // namespace proskill::lsp
