#pragma once

#include "view/http.h"
#include "view/panel_data.h"

#include <cstdint>

namespace proskill::view {

/// Access rules: pages with the token, at this port of this machine.
struct PanelAddress {
  std::uint16_t port = 0;
  std::string token;

  [[nodiscard]] std::string url() const;
};

/// 128 random bits in hexadecimal.
[[nodiscard]] std::string randomToken();

/// Serves the panel's page and its requests. A request without the token, or from a page of another
/// origin, gets only 403. Replies once, when there is something to report.
void answer(const HttpRequest& request, const PanelAddress& address, PanelData& data,
            EventFeed& news, const std::function<void(HttpResponse)>& reply);

} // namespace proskill::view
