#pragma once

#include <string>

namespace proskill::cli {

/// Does nothing if there is no browser; callers print the address.
void openBrowser(const std::string& url);

} // namespace proskill::cli
