#include "report/run/run_json.h"

#include "report/report_json.h"
#include "report/run/run_lines.h"
#include "report/sources.h"
#include "runtime/executor/description.h"

namespace proskill::report {

using runtime::Nanoseconds;
using runtime::RemarkKind;

syntax::Rational secondsOf(Nanoseconds date) {
  return ide::seconds(date, 1, {1, runtime::kSecond});
}

namespace {

void setDates(ide::TraceStep& step, Nanoseconds date, Nanoseconds before) {
  step.date = secondsOf(date);
  step.delay = secondsOf(date - before);
  step.earliest = {.seconds = step.date};
  step.latest = step.earliest;
}

class Recording final : public runtime::Observer {
public:
  Recording(AddToRecording to, RunSubject subject) : add(std::move(to)), lines(subject) {
    add(head(subject), kEnd);
  }

  void onStep(const runtime::Machine& machine, verify::TransitionId step, Nanoseconds date,
              Nanoseconds lag) override {
    record(lines.step(machine, step, date, lag));
  }

  void onRemark(const runtime::Remark& remark) override { record(lines.remark(remark)); }

private:
  static constexpr std::string_view kEnd = "\n]}\n";

  static std::string head(RunSubject subject) {
    auto text = dumped(runHeadJson(subject));
    text.back() = ',';
    return text + "\"steps\":[\n";
  }

  void record(std::string_view object) {
    addition = isFirst ? "" : ",\n";
    isFirst = false;
    addition += object;
    add(addition, kEnd);
  }

  AddToRecording add;
  RunLines lines;
  bool isFirst = true;
  std::string addition;
};

} // namespace

OrderedJson runHeadJson(RunSubject subject) {
  const auto& main = subject.executable.model.mainSkill;
  OrderedJson json{{"name", "run"},
                   {"description", "a recorded run of " +
                                       (main.empty() ? "a library of skills" : "`" + main + "`")},
                   {"verdict", "recorded"},
                   {"program", subject.program.files.front().path.generic_string()},
                   {"sources", sourcesJson(subject.program)},
                   {"main", main},
                   {"environment", subject.executable.model.hasEnvironment}};
  json["initial"] = OrderedJson::object();
  for (const auto& value : runtime::initialValues(subject.executable))
    json["initial"][value.variable] = value.after;
  return json;
}

std::string dumped(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

ide::TraceStep runStep(RunSubject subject, const runtime::Machine& machine,
                       verify::TransitionId step, Nanoseconds date, Nanoseconds before) {
  auto made = ide::inWords(runtime::lastStep(subject.executable, machine, step),
                           subject.executable.model.provenance);
  setDates(made, date, before);
  return made;
}

ide::TraceStep runStep(RunSubject subject, const runtime::Remark& remark, Nanoseconds before) {
  ide::TraceStep made;
  if (remark.origin != 0)
    made = ide::inWords({.origins = {remark.origin}}, subject.executable.model.provenance);
  made.actor = remark.subject.empty() ? "run" : std::string(remark.subject);
  made.description = std::string(toString(remark.kind)) + ": " + std::string(remark.text);
  if (remark.kind == RemarkKind::Started)
    made.description =
        "its action starts: " + runtime::commandText(remark.start->call, remark.subject);
  if (remark.kind == RemarkKind::Asked)
    made.description = "the platform is asked to stop its action";
  setDates(made, remark.date, before);
  return made;
}

std::string_view toString(RemarkKind kind) {
  switch (kind) {
  case RemarkKind::Started: return "started";
  case RemarkKind::Asked: return "asked to stop";
  case RemarkKind::GuardFailed: return "failed invariant";
  case RemarkKind::Note: return "note";
  case RemarkKind::Holds: return "holds";
  case RemarkKind::Undershoot: return "undershoot";
  case RemarkKind::Overshoot: return "overshoot";
  case RemarkKind::Alarm: return "alarm";
  case RemarkKind::Fault: return "fault";
  case RemarkKind::Violated: return "violated";
  }
  return "";
}

std::unique_ptr<runtime::Observer> runRecording(AddToRecording add, RunSubject subject) {
  return std::make_unique<Recording>(std::move(add), subject);
}

} // namespace proskill::report
