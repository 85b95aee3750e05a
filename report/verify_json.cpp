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

/// Writes a list in the form of `dump`, item by item. \param write writes an item
template <class Items, class Write>
void writeList(std::ostream& out, const Items& items, std::string_view indentation,
               const Write& write) {
  out << '[';
  std::string_view before = "\n";
  for (const auto& item : items) {
    out << std::exchange(before, ",\n") << indentation << "  ";
    write(item);
  }
  if (!items.empty()) out << '\n' << indentation;
  out << ']';
}

/// Writes an object in the form of `dump`. \param write writes the value of a key, or returns false
template <class Write>
void writeObject(std::ostream& out, const OrderedJson& json, const std::string& indentation,
                 const Write& write) {
  std::string_view before = "{\n";
  for (const auto& [key, value] : json.items()) {
    out << std::exchange(before, ",\n") << indentation << "  " << OrderedJson(key) << ": ";
    if (!write(key)) writeIndented(out, value, indentation + "  ");
  }
  out << '\n' << indentation << '}';
}

void writeTraceJson(std::ostream& out, const analysis::Program& program, const ide::Trace& trace) {
  writeObject(out, traceJsonWithoutSteps(program, trace), "      ", [&](std::string_view key) {
    if (key != "steps") return false;
    writeList(out, trace.steps, "        ", [&](const ide::TraceStep& step) {
      writeIndented(out, stepJson(program, step), "          ");
    });
    return true;
  });
}

void writeProperty(std::ostream& out, const VerifyReport& report, const ide::VerdictRow& row) {
  const ide::Trace* trace = shownTrace(row, report.traces);
  writeObject(out, propertyJson(report.program, row, ShowTraces::None), "    ",
              [&](std::string_view key) {
                if (key != "trace" || !trace) return false;
                writeTraceJson(out, report.program, *trace);
                return true;
              });
}

} // namespace

/// Writes step by step: the JSON of a trace takes many times the memory of the trace itself.
void writeJson(std::ostream& out, const VerifyReport& report) {
  out << "{\n";
  const auto head = reportHeadJson(report);
  for (const auto& [key, value] : head.items()) {
    out << "  " << OrderedJson(key) << ": ";
    writeIndented(out, value, "  ");
    out << ",\n";
  }
  out << "  \"properties\": ";
  writeList(out, report.result.rows, "  ",
            [&](const ide::VerdictRow& row) { writeProperty(out, report, row); });
  out << ",\n  \"exploration\": ";
  writeIndented(out, explorationJson(report.result.exploration), "  ");
  out << "\n}\n";
}

} // namespace proskill::report
