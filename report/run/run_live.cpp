#include "report/run/run_lines.h"
#include "report/run/run_places.h"

namespace proskill::report {

using runtime::Nanoseconds;
using State = std::vector<verify::Word>;

namespace {

class RunLive final : public runtime::Observer {
public:
  RunLive(PushLine to, RunSubject of) : push(std::move(to)), lines(of), places(of) {}

  void onStep(const runtime::Machine& machine, verify::TransitionId step, Nanoseconds date,
              Nanoseconds lag) override {
    const auto& before = machine.stateBefore();
    if (missing > 0) pushMissing(before, date);
    if (missing == 0 &&
        pushWithMoves(lines.step(machine, step, date, lag), before, machine.state()))
      return;
    if (!std::exchange(knowsState, true)) lastShown = before;
    ++missing;
  }

  void onRemark(const runtime::Remark& remark) override {
    if (missing > 0 || !push(lines.remark(remark))) ++missing;
  }

private:
  void pushMissing(const State& now, Nanoseconds date) {
    // if only remarks are missing, the state has not changed
    const auto& from = knowsState ? lastShown : now;
    if (!pushWithMoves(lines.missed(missing, from, now, date), from, now)) return;
    missing = 0;
    knowsState = false;
  }

  bool pushWithMoves(std::string_view object, const State& before, const State& after) {
    line = object;
    line.back() = ',';
    line += "\"moves\":";
    places.addMoves(line, before, after);
    line += '}';
    return push(line);
  }

  PushLine push;
  RunLines lines;
  RunPlaces places;
  std::string line;
  std::uint64_t missing = 0;
  bool knowsState = false; ///< whether `lastShown` is set
  State lastShown;         ///< the state after the last line
};

} // namespace

OrderedJson runPlacesJson(RunSubject subject) { return RunPlaces(subject).json(); }

std::unique_ptr<runtime::Observer> runLive(PushLine push, RunSubject subject) {
  return std::make_unique<RunLive>(std::move(push), subject);
}

} // namespace proskill::report
