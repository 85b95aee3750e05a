#include "cli/output/bridge_report.h"

#include "cli/terminal/exit_code.h"
#include "syntax/text/utf8.h"

#include <iostream>

namespace proskill::cli {
namespace {

void print(const bridge::Place& place, const std::string& message) {
  std::cerr << syntax::printable(place.file.generic_string()) << ':' << place.line << ':'
            << place.column << ": " << syntax::printable(message) << '\n';
}

} // namespace

int reportErrors(const bridge::Errors& errors) {
  for (const auto& [place, message] : errors) print(place, "error: " + message);
  return kFailed;
}

void reportNotes(const std::vector<bridge::Note>& notes) {
  for (const auto& [place, message] : notes) print(place, message);
}

} // namespace proskill::cli
