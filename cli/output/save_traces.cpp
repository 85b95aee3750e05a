#include "cli/output/save_traces.h"

#include "disk/output.h"
#include "report/verify_report.h"

#include <fmt/format.h>

#include <sstream>

namespace proskill::cli {

namespace {

std::string json(const VerifyReport& report, const ide::VerdictRow& row) {
  using Json = nlohmann::ordered_json;
  Json trace{{"name", row.check->name},
             {"words", row.check->words},
             {"verdict", ide::toString(row.verdict)}};
  trace.update(lsp::traceJson(report.program, *row.trace));
  return trace.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string text(const VerifyReport& report, const ide::VerdictRow& row) {
  std::ostringstream out;
  out << row.check->words << ": " << ide::toString(row.verdict) << '\n';
  for (const auto& variable : row.trace->initial)
    out << "    " << variable.variable << ' ' << variable.after << '\n';
  writeTrace(out, report, row, false);
  return out.str();
}

} // namespace

std::optional<std::string> saveTraces(const std::filesystem::path& directory,
                                      const VerifyReport& report) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    return fmt::format("{} cannot be made a directory: {}", directory.string(), error.message());
  for (const auto& row : report.result.rows) {
    if (!row.trace) continue;
    auto base = directory / row.check->name;
    if (auto failed = writeFile(base.string() + ".json", json(report, row))) return failed;
    if (auto failed = writeFile(base.string() + ".txt", text(report, row))) return failed;
  }
  return std::nullopt;
}

} // namespace proskill::cli
