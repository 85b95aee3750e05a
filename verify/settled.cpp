#include "verify/settled.h"

#include "verify/checkpoint/parts.h"

namespace proskill::verify {

namespace {

constexpr std::size_t kLongestReason = std::size_t{1} << 16; // bytes

void write(CheckpointWriter& to, const std::optional<std::size_t>& number) {
  to.number(number ? *number + 1 : 0);
}

std::optional<std::size_t> readOptional(CheckpointReader& from) {
  const auto number = from.number();
  return number == 0 ? std::nullopt : std::optional<std::size_t>(number - 1);
}

void write(CheckpointWriter& to, const MonitorMove& mark) {
  to.number(mark.after);
  to.number(mark.until);
  to.number(mark.atStep ? 1 : 0);
  to.number(mark.atEnd ? 1 : 0);
  to.number(mark.ticks ? 1 : 0);
  to.number(mark.location);
  to.number(mark.edge);
}

MonitorMove readMark(CheckpointReader& from) {
  MonitorMove mark;
  mark.after = from.number();
  mark.until = from.number();
  mark.atStep = from.flag();
  mark.atEnd = from.flag();
  mark.ticks = from.flag();
  mark.location = from.indexBelow(kNone);
  mark.edge = from.indexBelow(std::uint64_t{kNone} + 1);
  return mark;
}

void write(CheckpointWriter& to, const Evidence& evidence) {
  writeSteps(to, evidence.steps);
  to.number(evidence.clocks.size());
  for (const auto& it : evidence.clocks) {
    to.number(it.clock);
    to.signedNumber(it.lower);
    to.signedNumber(it.upper);
  }
  to.number(evidence.differences.size());
  for (const auto& it : evidence.differences) {
    to.number(it.a);
    to.number(it.b);
    to.signedNumber(it.limit);
  }
  to.number(evidence.marks.size());
  for (const auto& mark : evidence.marks) write(to, mark);
  write(to, evidence.loop);
  write(to, evidence.rest);
}

Bound readBound(CheckpointReader& from) {
  const auto bound = from.signedNumber();
  if (bound < INT32_MIN || bound > INT32_MAX) from.fail();
  return static_cast<Bound>(bound);
}

/// Calls `read` as often as the number says that comes first.
template <class Read> void readEach(CheckpointReader& from, Read read) {
  for (auto left = from.number(); left > 0 && !from.hasFailed(); --left) read();
}

Evidence readEvidence(CheckpointReader& from) {
  constexpr auto kAny = std::uint64_t{kNone} + 1;
  Evidence made;
  made.steps = readSteps(from, kNone);
  readEach(from, [&] {
    auto& it = made.clocks.emplace_back();
    it.clock = from.indexBelow(kAny);
    it.lower = readBound(from);
    it.upper = readBound(from);
  });
  readEach(from, [&] {
    auto& it = made.differences.emplace_back();
    it.a = from.indexBelow(kAny);
    it.b = from.indexBelow(kAny);
    it.limit = readBound(from);
  });
  readEach(from, [&] { made.marks.push_back(readMark(from)); });
  made.loop = readOptional(from);
  made.rest = readOptional(from);
  return made;
}

void write(CheckpointWriter& to, const std::optional<Duration>& duration) {
  to.number(duration ? 1 : 0);
  if (!duration) return;
  to.number(duration->happens ? 1 : 0);
  to.number(duration->bounded ? 1 : 0);
  to.signedNumber(duration->value.value);
  to.number(duration->value.strict ? 1 : 0);
}

std::optional<Duration> readDuration(CheckpointReader& from) {
  if (!from.flag()) return std::nullopt;
  Duration made;
  made.happens = from.flag();
  made.bounded = from.flag();
  made.value.value = from.signedNumber();
  made.value.strict = from.flag();
  return made;
}

void write(CheckpointWriter& to, const Settled::Decided& decided) {
  to.number(decided.question);
  to.text(decided.reason);
  to.number(decided.answer.holds ? 1 : 0);
  write(to, decided.answer.evidence);
  write(to, decided.answer.duration);
}

} // namespace

void write(CheckpointWriter& to, const Settled& settled, std::size_t decided) {
  to.number(decided);
  for (std::size_t i = 0; i < decided; ++i) write(to, settled.decided[i]);
  writeCounts(to, settled.exploration);
  to.number(settled.asked.size());
  for (const auto question : settled.asked) to.number(question);
  to.number(settled.stage);
  to.number(settled.slicesAreDone ? 1 : 0);
  to.number(settled.statesAreDone ? 1 : 0);
}

Settled readSettled(CheckpointReader& from, std::size_t questions) {
  Settled made;
  readEach(from, [&] {
    auto& it = made.decided.emplace_back();
    it.question = from.numberBelow(questions);
    it.reason = from.text(kLongestReason);
    it.answer.holds = from.flag();
    it.answer.evidence = readEvidence(from);
    it.answer.duration = readDuration(from);
  });
  made.exploration = readCounts(from);
  readEach(from, [&] { made.asked.push_back(from.numberBelow(questions)); });
  made.stage = from.number();
  made.slicesAreDone = from.flag();
  made.statesAreDone = from.flag();
  return made;
}

} // namespace proskill::verify
