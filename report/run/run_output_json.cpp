#include "report/report_json.h"
#include "report/run/run_json.h"
#include "report/run/run_lines.h"

#include <ostream>

/// A run as `proskill run --format json` prints it.
namespace proskill::report {

using runtime::Nanoseconds;

namespace {

class RunJson final : public runtime::Observer {
public:
  RunJson(std::ostream& to, RunSubject of) : out(to), lines(of) {}

  void onStep(const runtime::Machine& machine, verify::TransitionId step, Nanoseconds date,
              Nanoseconds lag) override {
    write(R"({"kind":"step",)", lines.step(machine, step, date, lag));
  }

  void onRemark(const runtime::Remark& remark) override {
    write(R"({"kind":"remark",)", lines.remark(remark));
  }

private:
  void write(std::string_view begin, std::string_view object) {
    out << begin << object.substr(1) << '\n';
  }

  std::ostream& out;
  RunLines lines;
};

} // namespace

std::unique_ptr<runtime::Observer> runJson(std::ostream& out, RunSubject subject) {
  return std::make_unique<RunJson>(out, subject);
}

OrderedJson runPropertiesJson(RunSubject subject,
                              const std::vector<runtime::PropertyMonitors::Decision>& verdicts) {
  using runtime::Verdict;
  OrderedJson list = OrderedJson::array();
  for (std::size_t i = 0; i < subject.executable.properties.size(); ++i) {
    const auto& of = subject.executable.properties[i];
    const auto& check = subject.executable.model.checks[of.check];
    const auto step =
        ide::inWords({.origins = {check.origin}}, subject.executable.model.provenance);
    const auto verdict = i < verdicts.size() ? verdicts[i].verdict : Verdict::NotYet;
    const auto why = whyNotMonitored(of);
    list.push_back({{"name", check.name},
                    {"description", check.description},
                    {"location",
                     step.location ? locationJson(subject.program, *step.location) : OrderedJson()},
                    {"verdict", toString(verdict)},
                    {"date", verdict == Verdict::NotYet
                                 ? OrderedJson()
                                 : OrderedJson(syntax::toString(secondsOf(verdicts[i].date)))},
                    {"whyNot", why.empty() ? OrderedJson() : OrderedJson(why)}});
  }
  return list;
}

void writeRunSummaryJson(std::ostream& out, RunSubject subject, const runtime::RunResult& result) {
  OrderedJson json{{"kind", "end"},
                   {"why", toWords(result.end)},
                   {"date", syntax::toString(secondsOf(result.date))},
                   {"steps", result.steps},
                   {"bad", result.bad},
                   {"mission", result.missionStatus},
                   {"properties", runPropertiesJson(subject, result.verdicts)}};
  if (!result.failure.empty()) json["failure"] = result.failure;
  out << dumped(json) << '\n';
}

} // namespace proskill::report
