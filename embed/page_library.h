#pragma once

#include "view/run_page.h"

namespace proskill::embed {

/// Serves a page by `libproskill_view.so`, which is loaded by the first call and stays loaded. The
/// threads of the page take no signals.
[[nodiscard]] view::OpenedPage openPage(view::ObservedRun run, std::uint16_t port);

} // namespace proskill::embed
