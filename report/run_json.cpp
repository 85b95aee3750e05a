#include "report/run_json.h"

#include "report/report_json.h"
#include "runtime/executor/description.h"

#include <ostream>

namespace proskill::report {

using runtime::Nanoseconds;
using runtime::RemarkKind;

namespace {

syntax::Rational secondsOf(Nanoseconds date) {
  return ide::seconds(date, 1, {1, runtime::kSecond});
}

void setDates(ide::TraceStep& step, Nanoseconds date, Nanoseconds before) {
  step.date = secondsOf(date);
  step.delay = secondsOf(date - before);
  step.earliest = {.seconds = step.date};
  step.latest = step.earliest;
}

OrderedJson machineStepJson(RunSubject subject, const runtime::Machine& machine,
                            verify::TransitionId step, Nanoseconds date, Nanoseconds before,
                            Nanoseconds lag) {
  auto json = stepJson(subject.program, runStep(subject, machine, step, date, before));
  if (lag > 0) json["lag"] = static_cast<double>(lag) / static_cast<double>(runtime::kSecond);
  const auto stops = runtime::stoppingSkill(subject.executable, machine);
  if (!stops.empty()) json["stops"] = stops;
  return json;
}

OrderedJson remarkJson(RunSubject subject, const runtime::Remark& remark, Nanoseconds before) {
  auto json = stepJson(subject.program, runStep(subject, remark, before));
  json["remark"] = toString(remark.kind);
  if (!remark.start) return json;
  json["run"] = remark.start->run;
  if (remark.start->call)
    json["action"] = {{"command", remark.start->call->command},
                      {"arguments", remark.start->call->arguments}};
  return json;
}

std::string dumped(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

class RunJson final : public runtime::Observer {
public:
  RunJson(std::ostream& to, RunSubject of) : out(to), subject(of) {}

  void onStep(const runtime::Machine& machine, verify::TransitionId step, Nanoseconds date,
              Nanoseconds lag) override {
    auto json = machineStepJson(subject, machine, step, date, before, lag);
    write(std::move(json), "step", date);
  }

  void onRemark(const runtime::Remark& remark) override {
    write(remarkJson(subject, remark, before), "remark", remark.date);
  }

private:
  void write(OrderedJson json, std::string_view kind, Nanoseconds date) {
    OrderedJson line{{"kind", kind}};
    line.update(json);
    out << dumped(line) << '\n';
    before = date;
  }

  std::ostream& out;
  RunSubject subject;
  Nanoseconds before = 0;
};

class Recording final : public runtime::Observer {
public:
  Recording(AddToRecording to, RunSubject of, std::size_t several)
      : add(std::move(to)), subject(of), batch(several) {
    OrderedJson head{{"name", "run"},
                     {"description", "a recorded run of " + missionName()},
                     {"verdict", "recorded"},
                     {"program", subject.program.files.front().path.generic_string()},
                     {"main", subject.executable.model.mainSkill},
                     {"environment", subject.executable.model.hasEnvironment}};
    head["initial"] = OrderedJson::object();
    for (const auto& value : runtime::initialValues(subject.executable))
      head["initial"][value.variable] = value.after;
    pending = dumped(head);
    pending.back() = ',';
    pending += "\"steps\":[\n";
    write();
  }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  ~Recording() override { write(); }

  void onStep(const runtime::Machine& machine, verify::TransitionId step, Nanoseconds date,
              Nanoseconds lag) override {
    auto json = machineStepJson(subject, machine, step, date, before, lag);
    record(json, date);
  }

  void onRemark(const runtime::Remark& remark) override {
    record(remarkJson(subject, remark, before), remark.date);
  }

private:
  [[nodiscard]] std::string missionName() const {
    const auto& main = subject.executable.model.mainSkill;
    return main.empty() ? "a library of skills" : "`" + main + "`";
  }

  void record(const OrderedJson& json, Nanoseconds date) {
    if (!isFirst) pending += ",\n";
    isFirst = false;
    pending += dumped(json);
    before = date;
    if (++waiting >= batch) write();
  }

  void write() {
    add(pending, "\n]}\n");
    pending.clear();
    waiting = 0;
  }

  AddToRecording add;
  RunSubject subject;
  std::size_t batch;
  std::size_t waiting = 0;
  bool isFirst = true;
  std::string pending;
  Nanoseconds before = 0;
};

} // namespace

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
  case RemarkKind::Undershoot: return "undershoot";
  case RemarkKind::Overshoot: return "overshoot";
  case RemarkKind::Alarm: return "alarm";
  case RemarkKind::Fault: return "fault";
  }
  return "";
}

std::unique_ptr<runtime::Observer> runJson(std::ostream& out, RunSubject subject) {
  return std::make_unique<RunJson>(out, subject);
}

std::unique_ptr<runtime::Observer> runRecording(AddToRecording add, RunSubject subject,
                                                std::size_t batch) {
  return std::make_unique<Recording>(std::move(add), subject, batch);
}

void writeRunSummaryJson(std::ostream& out, const runtime::RunResult& result) {
  OrderedJson json{{"kind", "end"},
                   {"why", toWords(result.end)},
                   {"date", syntax::toString(secondsOf(result.date))},
                   {"steps", result.steps},
                   {"bad", result.bad},
                   {"mission", result.missionStatus}};
  if (!result.failure.empty()) json["failure"] = result.failure;
  out << dumped(json) << '\n';
}

} // namespace proskill::report
