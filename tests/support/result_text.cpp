#include "tests/support/result_text.h"

#include <sstream>

namespace proskill::test {

namespace {

void writeTrace(std::ostream& out, const verify::Trace& trace) {
  out << "  trace in units of 1/" << trace.scale << '\n';
  for (const auto& step : trace.steps) {
    out << "    at " << step.date << ':';
    for (auto transition : step.transitions) out << ' ' << transition;
    out << '\n';
  }
}

} // namespace

std::string textOf(const verify::Result& result) {
  const auto& size = result.exploration;
  std::ostringstream out;
  out << size.classes << " classes, " << size.markings << " markings, " << size.domains
      << " domains, " << size.transitions << " transitions, "
      << (size.complete ? "complete" : "stopped: " + size.stopped) << '\n';
  for (const auto& answer : result.answers) {
    out << static_cast<int>(answer.truth) << ' ' << answer.reason << '\n';
    if (answer.trace) writeTrace(out, *answer.trace);
  }
  return out.str();
}

} // namespace proskill::test
