#pragma once

#include "report/run/run_report.h"

namespace proskill::report {

/// The machine's last step in the program's terms, with its date.
[[nodiscard]] ide::TraceStep runStep(RunSubject subject, const runtime::Machine& machine,
                                     verify::TransitionId step, runtime::Nanoseconds date,
                                     runtime::Nanoseconds before);
/// A remark in the form of a step.
[[nodiscard]] ide::TraceStep runStep(RunSubject subject, const runtime::Remark& remark,
                                     runtime::Nanoseconds before);
[[nodiscard]] syntax::Rational secondsOf(runtime::Nanoseconds date);
/// In one line; invalid UTF-8 is replaced.
[[nodiscard]] std::string dumped(const OrderedJson& json);
/// `undershoot`
[[nodiscard]] std::string_view toString(runtime::RemarkKind kind);

} // namespace proskill::report
