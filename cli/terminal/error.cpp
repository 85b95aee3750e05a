#include "cli/terminal/error.h"

#include "cli/terminal/exit_code.h"
#include "syntax/text/utf8.h"

#include <iostream>
#include <unistd.h>

namespace proskill::cli {

int fail(std::string_view message) {
  std::cerr << "error: " << syntax::printable(message, "\n\t") << '\n';
  return kFailed;
}

std::string forOutput(std::string_view text) {
  return isatty(STDOUT_FILENO) == 1 ? syntax::printable(text, "\n\t") : std::string(text);
}

} // namespace proskill::cli
