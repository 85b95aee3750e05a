#pragma once

#include "lsp/protocol/client.h"

namespace proskill::lsp {

/// The `ServerCapabilities` that this client is offered. \param features what the registry offers
[[nodiscard]] Json capabilitiesFor(const ClientFeatures& client, Json features);

/// The registrations to ask the client for, as `client/registerCapability` takes them; an empty
/// list where the client registers nothing dynamically.
[[nodiscard]] Json registrationsFor(const ClientFeatures& client);

} // namespace proskill::lsp
