#pragma once

#include "lsp/protocol/client.h"

namespace proskill::lsp {

/// The `ServerCapabilities` for this client. \param features offered by the registry
[[nodiscard]] Json capabilitiesFor(const ClientFeatures& client, Json features);

/// The registrations for `client/registerCapability`; empty if the client has no dynamic
/// registration.
[[nodiscard]] Json registrationsFor(const ClientFeatures& client);

} // namespace proskill::lsp
