#include "report/check/check_report.h"

#include "report/text/render.h"
#include "report/text/source_place.h"
#include "report/text/text_width.h"
#include "syntax/text/utf8.h"

#include <ostream>
#include <set>

namespace proskill::report {

FindingCounts countFindings(std::span<const CheckedProgram> programs) {
  FindingCounts counts;
  std::set<std::string> files;
  for (const CheckedProgram& checked : programs) {
    for (const analysis::File& file : checked.program.files)
      files.insert(file.path.generic_string());
    for (const syntax::Diagnostic& diagnostic : checked.diagnostics) {
      switch (diagnostic.severity) {
      case syntax::Severity::Error: ++counts.errors; break;
      case syntax::Severity::Warning: ++counts.warnings; break;
      case syntax::Severity::Hint: ++counts.hints; break;
      }
    }
  }
  counts.files = files.size();
  return counts;
}

void writeCheckShort(std::ostream& out, std::span<const CheckedProgram> programs) {
  for (const CheckedProgram& checked : programs) {
    SourcePlaces places(checked.program);
    for (const syntax::Diagnostic& diagnostic : checked.diagnostics) {
      const SourcePlace at = places.begin(diagnostic.location);
      out << syntax::printable(places.path(diagnostic.location.file)) << ':' << at.line << ':'
          << at.column << ": " << words(diagnostic.severity) << '['
          << syntax::info(diagnostic.code).id << "]: " << DisplayedLine(diagnostic.message).text()
          << '\n';
    }
  }
}

} // namespace proskill::report
