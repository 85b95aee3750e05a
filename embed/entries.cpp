#include "embed/entries.h"

#include "runtime/executor/description.h"
#include "verify/trace/step_description.h"

#include <fmt/format.h>

#include <exception>

namespace proskill::embed {

namespace {

using runtime::RemarkKind;

double inSeconds(runtime::Nanoseconds date) {
  return static_cast<double>(date) / static_cast<double>(runtime::kSecond);
}

proskill_entry_kind kindOf(RemarkKind kind) {
  switch (kind) {
  case RemarkKind::Started: return PROSKILL_STARTED;
  case RemarkKind::Asked: return PROSKILL_ASKED_TO_STOP;
  case RemarkKind::GuardFailed: return PROSKILL_INVARIANT_FAILED;
  case RemarkKind::Note: return PROSKILL_NOTE;
  case RemarkKind::Holds: return PROSKILL_HOLDS;
  case RemarkKind::Undershoot: return PROSKILL_UNDERSHOOT;
  case RemarkKind::Overshoot: return PROSKILL_OVERSHOOT;
  case RemarkKind::Alarm: return PROSKILL_ALARM;
  case RemarkKind::Fault: return PROSKILL_FAULT;
  case RemarkKind::Violated: return PROSKILL_VIOLATED;
  }
  return PROSKILL_NOTE;
}

std::string textOf(const runtime::Remark& remark) {
  if (remark.start) return runtime::commandText(remark.start->call, remark.subject);
  if (remark.kind == RemarkKind::Asked) return "is asked to stop";
  return std::string(remark.text);
}

} // namespace

void Entries::onStep(const runtime::Machine& machine, verify::TransitionId step,
                     runtime::Nanoseconds date, runtime::Nanoseconds lag) {
  static_cast<void>(step);
  static_cast<void>(lag);
  if (!observer) return;
  const auto& provenance = executable.model.provenance;
  const auto all = verify::mostDescriptiveLast(provenance, machine.log());
  const fiacre::OriginId id = all.empty() ? 0 : all.back();
  auto text = provenance.origins[id].description;
  if (const auto message = runtime::printedMessage(executable, machine))
    text = fmt::format("prints \"{}\"", *message);
  report({.kind = PROSKILL_STEP,
          .time = inSeconds(date),
          .subject = provenance.origins[id].actor.c_str(),
          .text = text.c_str()},
         id);
}

void Entries::onRemark(const runtime::Remark& remark) {
  if (!observer) return;
  const std::string subject(remark.subject);
  const auto text = textOf(remark);
  report({.kind = kindOf(remark.kind),
          .is_fault = isBad(remark.kind),
          .time = inSeconds(remark.date),
          .subject = subject.c_str(),
          .text = text.c_str()},
         remark.origin);
}

void Entries::report(proskill_entry entry, fiacre::OriginId origin) {
  const auto& from = executable.model.provenance.origins[origin];
  const bool hasPlace = from.begin != from.end && from.file < program.files.size();
  const auto path = hasPlace ? program.files[from.file].path.generic_string() : std::string();
  const auto place = hasPlace ? placeOf(program, {from.file, {from.begin, from.end}}) : Place{};
  entry.size = sizeof entry;
  entry.file = path.c_str();
  entry.line = place.line;
  entry.column = place.column;
  try {
    observer(owner, &entry, data);
  } catch (const std::exception& error) {
    trouble = fmt::format("the observer has thrown: {}", error.what());
  } catch (...) {
    trouble = "the observer has thrown an exception";
  }
}

} // namespace proskill::embed
