#include "report/run/run_lines.h"

#include "report/report_json.h"
#include "report/run/run_json.h"
#include "runtime/executor/description.h"
#include "verify/state/evaluate.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace proskill::report {

using runtime::Nanoseconds;
using runtime::RemarkKind;

namespace {

/// A transition with more paths is not cached.
constexpr std::size_t kMostPaths = 64;

void addNumber(std::string& to, std::int64_t number) {
  std::array<char, 24> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  to.append(digits.data(), end);
}

/// An exact decimal number of seconds without trailing zeros, valid in JSON.
std::string_view inSeconds(Nanoseconds time, std::array<char, 32>& room) {
  auto* at = std::to_chars(room.data(), room.data() + room.size(), time / runtime::kSecond).ptr;
  auto part = time % runtime::kSecond;
  if (part == 0) return {room.data(), at};
  *at++ = '.';
  for (auto unit = runtime::kSecond / 10; part != 0; part %= unit, unit /= 10)
    *at++ = static_cast<char>('0' + part / unit);
  return {room.data(), at};
}

/// `"exact":"2.5","seconds":2.5`
void addSeconds(std::string& to, std::string_view decimal) {
  to += R"("exact":")";
  to += decimal;
  to += R"(","seconds":)";
  to += decimal;
  if (decimal.find('.') == std::string_view::npos) to += ".0";
}

/// Whether the text of such a remark follows from the program.
bool isOfProgram(RemarkKind kind) {
  switch (kind) {
  case RemarkKind::Started:
  case RemarkKind::Asked:
  case RemarkKind::GuardFailed:
  case RemarkKind::Holds:
  case RemarkKind::Undershoot:
  case RemarkKind::Overshoot:
  case RemarkKind::Alarm:
  case RemarkKind::Violated: return true;
  case RemarkKind::Note:
  case RemarkKind::Fault: return false;
  }
  return false;
}

} // namespace

RunLines::RunLines(RunSubject of) : subject(of), paths(of.executable.system.transitions.size()) {
  for (std::size_t i = 0; i < subject.executable.shownVariables; ++i) {
    const auto& watched = subject.executable.system.watched[i];
    variables.push_back("{\"variable\":" + dumped(watched.display));
    auto& all = words.emplace_back();
    for (const auto& word : watched.words) all.push_back(dumped(word));
  }
  for (const auto& performed : subject.executable.model.performed)
    stops.push_back(",\"stops\":" + dumped(performed.skill));
}

std::string_view RunLines::step(const runtime::Machine& machine, verify::TransitionId step,
                                Nanoseconds date, Nanoseconds lag) {
  const auto& frame = frameOf(machine, step);
  line = frame.begin;
  addDates(date);
  addChanges(machine.stateBefore(), machine.state());
  line += frame.end;
  if (const auto message = runtime::printedMessage(subject.executable, machine))
    line += ",\"message\":" + dumped(*message);
  if (lag > 0) {
    std::array<char, 32> room{};
    line += ",\"lag\":";
    line += inSeconds(lag, room);
  }
  if (const auto action = runtime::stoppingAction(subject.executable, machine))
    line += stops[*action];
  line += '}';
  return line;
}

std::string_view RunLines::remark(const runtime::Remark& remark) {
  const auto& frame = frameOf(remark);
  line = frame.begin;
  addDates(remark.date);
  line += "],";
  line += frame.end;
  if (remark.start) {
    line += ",\"run\":";
    addNumber(line, static_cast<std::int64_t>(remark.start->run));
  }
  line += '}';
  return line;
}

std::string_view RunLines::missed(std::uint64_t count, const std::vector<verify::Word>& from,
                                  const std::vector<verify::Word>& to, Nanoseconds date) {
  const auto text = std::to_string(count) + " steps and remarks are not shown";
  const auto& frame = frameOf({.kind = RemarkKind::Note, .date = date, .text = text});
  line = frame.begin;
  addDates(date);
  addChanges(from, to);
  line += frame.end;
  line += '}';
  return line;
}

const RunLines::Frame& RunLines::frameOf(const runtime::Machine& machine,
                                         verify::TransitionId step) {
  const auto& log = machine.log();
  auto& known = paths[step];
  for (const auto& path : known)
    if (path.origins == log.origins && path.leaves == log.leaves) return path.frame;
  auto raw = runtime::lastStep(subject.executable, machine, step);
  raw.changes.clear();
  auto frame = frameOf(ide::inWords(std::move(raw), subject.executable.model.provenance));
  if (known.size() == kMostPaths) return lastFrame = std::move(frame);
  return known.emplace_back(Path{log.origins, log.leaves, std::move(frame)}).frame;
}

const RunLines::Frame& RunLines::frameOf(const runtime::Remark& remark) {
  const bool isKept = isOfProgram(remark.kind);
  const auto* call = remark.start ? remark.start->call : nullptr;
  const RemarkKey key{remark.kind, remark.subject.data(), call, remark.origin};
  if (isKept)
    if (const auto found = remarks.find(key); found != remarks.end()) return found->second;
  auto frame = frameOf(runStep(subject, remark, before));
  frame.end += ",\"remark\":" + dumped(toString(remark.kind));
  if (call)
    frame.end +=
        ",\"action\":" + dumped({{"command", call->command}, {"arguments", call->arguments}});
  if (isKept) return remarks.emplace(key, std::move(frame)).first->second;
  return lastFrame = std::move(frame);
}

RunLines::Frame RunLines::frameOf(const ide::TraceStep& step) const {
  const auto whole = stepJson(subject.program, step);
  OrderedJson begin;
  OrderedJson end;
  bool hasDates = false;
  for (const auto& [key, value] : whole.items()) {
    hasDates = hasDates || key == "date";
    if (!hasDates) begin[key] = value;
    if (key == "why" || !end.empty()) end[key] = value;
  }
  Frame frame{dumped(begin), dumped(end)};
  frame.begin.back() = ',';
  frame.end.erase(0, 1);
  frame.end.pop_back();
  return frame;
}

void RunLines::addDates(Nanoseconds date) {
  std::array<char, 32> room{};
  const auto decimal = inSeconds(date, room);
  std::array<char, 32> delayRoom{};
  line += "\"date\":{";
  addSeconds(line, decimal);
  line += "},\"delay\":{";
  addSeconds(line, inSeconds(std::max<Nanoseconds>(date - before, 0), delayRoom));
  line += "},\"earliest\":{";
  addSeconds(line, decimal);
  line += ",\"strict\":false},\"latest\":{";
  addSeconds(line, decimal);
  line += ",\"strict\":false},\"changes\":[";
  before = date;
}

void RunLines::addChanges(const std::vector<verify::Word>& from,
                          const std::vector<verify::Word>& to) {
  const auto& system = subject.executable.system;
  bool isFirst = true;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const auto cell = system.watched[i].cell;
    const auto old = verify::readCell(system, cell, from.data());
    const auto now = verify::readCell(system, cell, to.data());
    if (old == now) continue;
    if (!isFirst) line += ',';
    isFirst = false;
    line += variables[i];
    line += ",\"before\":";
    addValue(i, old);
    line += ",\"after\":";
    addValue(i, now);
    line += '}';
  }
  line += "],";
}

void RunLines::addValue(std::size_t variable, std::int64_t value) {
  const auto& known = words[variable];
  if (value >= 0 && static_cast<std::size_t>(value) < known.size()) {
    line += known[static_cast<std::size_t>(value)];
    return;
  }
  line += '"';
  addNumber(line, value);
  line += '"';
}

} // namespace proskill::report
