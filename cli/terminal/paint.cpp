#include "cli/terminal/paint.h"

#include "cli/terminal/choice.h"

#include <cstdlib>
#include <unistd.h>

namespace proskill::cli {

bool wantsColour(ColourChoice choice, int fileDescriptor) {
  if (choice != ColourChoice::Auto) return choice == ColourChoice::Always;
  const char* none = std::getenv("NO_COLOR");
  return isatty(fileDescriptor) == 1 && (none == nullptr || *none == '\0');
}

void addColour(CLI::App& command, ColourChoice& choice) {
  addChoice<ColourChoice>(command, "--color", choice,
                          {{"auto", ColourChoice::Auto},
                           {"always", ColourChoice::Always},
                           {"never", ColourChoice::Never}},
                          "Colours; auto: on a terminal where NO_COLOR is not set");
}

} // namespace proskill::cli
