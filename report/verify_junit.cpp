#include "report/verify_report.h"
#include "syntax/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <sstream>

namespace proskill::report {

namespace {

/// Whether XML 1.0 allows a character, escaped or not.
bool isXml(char32_t c) {
  return (c >= 0x20 && c != 0xFFFE && c != 0xFFFF) || c == U'\n' || c == U'\t' || c == U'\r';
}

/// Text for an element or an attribute. White space is escaped, since parsers would normalise it.
std::string escape(std::string_view text) {
  std::string out;
  syntax::forEachCharacter(text, [&](char32_t character, std::string_view bytes) {
    switch (character) {
    case U'&': out += "&amp;"; break;
    case U'<': out += "&lt;"; break;
    case U'>': out += "&gt;"; break;
    case U'"': out += "&quot;"; break;
    case U'\r': out += "&#13;"; break;
    default: out += isXml(character) ? bytes : syntax::kReplacement;
    }
  });
  return out;
}

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
                     escape(row.check->subject), escape(row.check->name));
  if (row.location) {
    const auto& file = report.program.files[row.location->file];
    out << fmt::format(" file=\"{}\" line=\"{}\"", escape(file.path.string()),
                       file.document.lines().position(row.location->range.begin).line + 1);
  }
  out << ">\n";
  if (fails(row))
    out << fmt::format("      <failure type=\"{}\" message=\"{}\">{}</failure>\n",
                       ide::toString(row.verdict), escape(row.check->description),
                       escape(traceText(report, row)));
  else if (row.verdict == ide::Verdict::Inconclusive)
    out << fmt::format("      <skipped message=\"inconclusive: {}\"/>\n", escape(row.reason));
  else if (row.bad())
    out << fmt::format("      <system-out>warning: {} ({})\n{}</system-out>\n",
                       escape(row.check->description), ide::toString(row.verdict),
                       escape(traceText(report, row)));
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
                     escape(report.program.files.front().path.string()),
                     report.result.exploration.seconds);
  for (const auto& suite : suites(report.result.rows)) {
    out << fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" skipped=\"{}\" time=\"0\">\n",
        escape(suite.name), suite.rows.size(), count(suite.rows, failed),
        count(suite.rows, skipped));
    for (const auto* row : suite.rows) writeCase(out, report, *row);
    out << "  </testsuite>\n";
  }
  out << "</testsuites>\n";
}

} // namespace proskill::report
