#include "report/verify_report.h"

#include <ostream>

namespace proskill::report {

void writeJson(std::ostream& out, const VerifyReport& report) {
  out << reportJson(report).dump(2, ' ', false, OrderedJson::error_handler_t::replace) << '\n';
}

} // namespace proskill::report
