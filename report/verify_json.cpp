#include "report/verify_report.h"

#include <ostream>

namespace proskill::cli {

void writeJson(std::ostream& out, const VerifyReport& report) {
  using Json = lsp::OrderedJson;
  out << lsp::reportJson(report).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

} // namespace proskill::cli
