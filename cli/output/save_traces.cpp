#include "cli/output/save_traces.h"

#include "disk/output.h"
#include "report/verify_report.h"

#include <fmt/format.h>

#include <sstream>

namespace proskill::cli {

namespace {

std::string json(const report::VerifyReport& report, const ide::VerdictRow& row) {
  OrderedJson trace{{"name", row.check->name},
                    {"description", row.check->description},
                    {"verdict", ide::toString(row.verdict)}};
  trace.update(report::traceJson(report.program, *row.trace));
  return trace.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

std::string text(const report::VerifyReport& report, const ide::VerdictRow& row) {
  std::ostringstream out;
  out << row.check->description << ": " << ide::toString(row.verdict) << '\n';
  for (const auto& variable : row.trace->initial)
    out << "    " << variable.variable << ' ' << variable.after << '\n';
  writeTrace(out, report, row, false);
  return out.str();
}

} // namespace

std::optional<std::string> saveTraces(const std::filesystem::path& directory,
                                      const report::VerifyReport& report) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    return fmt::format("cannot create the directory {}: {}", directory.string(), error.message());
  for (const auto& row : report.result.rows) {
    if (!row.trace) continue;
    auto base = directory / row.check->name;
    if (auto failed = disk::writeFile(base.string() + ".json", json(report, row))) return failed;
    if (auto failed = disk::writeFile(base.string() + ".txt", text(report, row))) return failed;
  }
  return std::nullopt;
}

} // namespace proskill::cli
