#include "lsp/protocol/client_settings.h"

namespace proskill::lsp {

namespace {

/// Limit, so that an absurd number does not overflow the clock.
constexpr std::uint64_t kLongestDebounce = 60'000;

void read(const Json& value, bool& setting) {
  if (value.is_boolean()) setting = value.get<bool>();
}

} // namespace

ClientSettings readClientSettings(const Json& json) {
  const Json& whole = rpc::memberAt(json, {"proskill"});
  const Json& section = whole.is_object() ? whole : json;
  ClientSettings settings;
  read(rpc::memberAt(section, {"diagnostics", "enabled"}), settings.diagnostics);
  read(rpc::memberAt(section, {"diagnostics", "style"}), settings.style);
  const Json& debounce = rpc::memberAt(section, {"diagnostics", "debounce"});
  if (debounce.is_number_unsigned())
    settings.debounce =
        std::chrono::milliseconds(std::min(debounce.get<std::uint64_t>(), kLongestDebounce));
  return settings;
}

} // namespace proskill::lsp
