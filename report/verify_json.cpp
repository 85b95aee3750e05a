#include "report/verify_report.h"

#include <ostream>

namespace proskill::report {

namespace {

/// Writes a value; all lines but the first are indented. Strings in JSON contain no line breaks.
void writeIndented(std::ostream& out, const OrderedJson& json, std::string_view indentation) {
  const std::string text = json.dump(2, ' ', false, OrderedJson::error_handler_t::replace);
  std::string_view rest = text;
  for (auto end = rest.find('\n'); end != rest.npos; end = rest.find('\n')) {
    out << rest.substr(0, end + 1) << indentation;
    rest.remove_prefix(end + 1);
  }
  out << rest;
}

} // namespace

/// Writes property by property: the JSON of all traces would take several times the memory of the
/// traces themselves.
void writeJson(std::ostream& out, const VerifyReport& report) {
  out << "{\n";
  const auto head = reportHeadJson(report);
  for (const auto& [key, value] : head.items()) {
    out << "  " << OrderedJson(key) << ": ";
    writeIndented(out, value, "  ");
    out << ",\n";
  }
  out << "  \"properties\": [";
  std::string_view before = "\n    ";
  for (const auto& row : report.result.rows) {
    out << std::exchange(before, ",\n    ");
    writeIndented(out, propertyJson(report.program, row, report.traces), "    ");
  }
  out << (report.result.rows.empty() ? "" : "\n  ") << "],\n  \"exploration\": ";
  writeIndented(out, explorationJson(report.result.exploration), "  ");
  out << "\n}\n";
}

} // namespace proskill::report
