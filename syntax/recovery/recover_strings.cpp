#include "syntax/diagnostics/codes.h"
#include "syntax/recovery/recover.h"

namespace proskill::syntax {

bool recoverStrings(std::string& text, const Scan& scan, std::vector<Diagnostic>& diagnostics) {
  for (Range range : scan.unterminated) {
    // the parentheses at the end of the line most likely follow the string
    Offset end = range.end;
    while (end > range.begin + 1 && (text[end - 1] == ')' || text[end - 1] == ' ')) --end;
    auto& diagnostic =
        diagnostics.emplace_back(makeDiagnostic(Code::UnterminatedString, {0, {range.begin, end}}));
    diagnostic.fixes.push_back({"insert `\"`", {0, {end, end}}, "\""});
    // the length must not change, so the quote replaces the last character of the string
    bool room = end > range.begin + 1 && text[end - 2] != '\\';
    if (room) text[end - 1] = '"';
  }
  return !scan.unterminated.empty();
}

} // namespace proskill::syntax
