#include "report/verify_report.h"
#include "syntax/text/xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <sstream>

namespace proskill::report {

namespace {

struct Suite {
  std::string name;
  std::vector<const ide::VerdictRow*> rows;
};

std::vector<Suite> suites(const std::vector<ide::VerdictRow>& rows) {
  std::vector<Suite> result;
  std::map<std::string, std::size_t> index;
  for (const auto& row : rows) {
    auto [entry, fresh] = index.try_emplace(row.check->subject, result.size());
    if (fresh) result.push_back({row.check->subject, {}});
    result[entry->second].rows.push_back(&row);
  }
  return result;
}

/// Whether a property counts as failed. A warning passes, and is reported in its output.
bool fails(const ide::VerdictRow& row) {
  return row.bad() && row.check->weight == codegen::Weight::Error;
}

std::string traceText(const VerifyReport& report, const ide::VerdictRow& row) {
  if (!shownTrace(row, report.traces)) return {};
  std::ostringstream text;
  writeTrace(text, report, row, false);
  return text.str();
}

void writeCase(std::ostream& out, const VerifyReport& report, const ide::VerdictRow& row) {
  out << fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"",
                     syntax::xmlAttribute(row.check->subject),
                     syntax::xmlAttribute(row.check->name));
  if (row.location) {
    const auto& file = report.program.files[row.location->file];
    out << fmt::format(" file=\"{}\" line=\"{}\"", syntax::xmlAttribute(file.path.string()),
                       file.document.lines().position(row.location->range.begin).line + 1);
  }
  out << ">\n";
  if (fails(row))
    out << fmt::format("      <failure type=\"{}\" message=\"{}\">{}</failure>\n",
                       ide::toString(row.verdict), syntax::xmlAttribute(row.check->description),
                       syntax::xmlText(traceText(report, row)));
  else if (row.verdict == ide::Verdict::Inconclusive)
    out << fmt::format("      <skipped message=\"inconclusive: {}\"/>\n",
                       syntax::xmlAttribute(row.reason));
  else if (row.bad())
    out << fmt::format("      <system-out>warning: {} ({})\n{}</system-out>\n",
                       syntax::xmlText(row.check->description), ide::toString(row.verdict),
                       syntax::xmlText(traceText(report, row)));
  out << "    </testcase>\n";
}

} // namespace

void writeJUnit(std::ostream& out, const VerifyReport& report) {
  auto count = [](const auto& rows, auto&& predicate) {
    return static_cast<std::size_t>(std::ranges::count_if(rows, predicate));
  };
  auto skipped = [](const ide::VerdictRow* row) {
    return row->verdict == ide::Verdict::Inconclusive;
  };
  auto failed = [](const ide::VerdictRow* row) { return fails(*row); };
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out << fmt::format("<testsuites name=\"{}\" time=\"{:.3f}\">\n",
                     syntax::xmlAttribute(report.program.files.front().path.string()),
                     report.result.exploration.seconds);
  for (const auto& suite : suites(report.result.rows)) {
    out << fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" skipped=\"{}\" time=\"0\">\n",
        syntax::xmlAttribute(suite.name), suite.rows.size(), count(suite.rows, failed),
        count(suite.rows, skipped));
    for (const auto* row : suite.rows) writeCase(out, report, *row);
    out << "  </testsuite>\n";
  }
  out << "</testsuites>\n";
}

} // namespace proskill::report
