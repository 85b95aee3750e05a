#include "runtime/conform/claims.h"

#include "runtime/executor/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

namespace proskill::runtime {

Claims::Why Claims::initial(const RecordedHead& head) {
  if (head.initial.empty()) return std::nullopt;
  for (const auto& value : head.initial) values[value.variable] = value.after;
  const auto all = initialValues(executable);
  for (const auto& [variable, before, after] : all)
    if (const auto found = values.find(variable); found == values.end())
      return fmt::format("the recording has no initial value of `{}`", variable);
    else if (found->second != after)
      return fmt::format("`{}` begins with `{}`, not with `{}`", variable, after, found->second);
  if (values.size() == all.size()) return std::nullopt;
  return "the recording has initial values of variables that the program does not have";
}

Claims::Why Claims::step(const RecordedStep& step) {
  auto wrong = message(step);
  for (const auto& change : step.changes) values[change.variable] = change.after;
  lastActor = step.what.actor;
  lastDate = step.date;
  return wrong;
}

Claims::Why Claims::call(const RecordedCall& call) const {
  if (lastActor != call.skill || lastDate != call.date)
    return fmt::format("the action of `{}` starts without a step of its skill", call.skill);
  const auto isThis = [&](const codegen::ActionCall& it) {
    return it.skill == call.skill && it.command == call.command && it.arguments == call.arguments;
  };
  // a caller that the program does not contain gives no arguments
  const bool isKnown =
      call.command.empty() || std::ranges::any_of(executable.model.actionCalls, isThis);
  if (isKnown) return std::nullopt;
  return fmt::format("no call of `{}` starts its action with this command and these arguments",
                     call.skill);
}

Claims::Why Claims::message(const RecordedStep& step) const {
  Why wrong;
  for (const auto& [id, message] : executable.messages) {
    if (!isAt(executable.model.provenance.origins[id], step.what)) continue;
    const auto text = textOf(message);
    if (!text || step.message == text) return std::nullopt;
    wrong = fmt::format("this step prints \"{}\"", *text);
  }
  if (wrong || step.message.empty()) return wrong;
  return "this step prints nothing";
}

bool Claims::isAt(const fiacre::Origin& origin, const fiacre::Origin& what) const {
  if (origin.actor != what.actor) return false;
  if (!placesMatter) return origin.description == what.description;
  return origin.file == what.file && origin.begin == what.begin && origin.end == what.end;
}

/// A message with the values that the recording has; nullopt if it lacks one of them.
Claims::Why Claims::textOf(const std::vector<MessagePart>& message) const {
  std::string text;
  for (const auto& part : message) {
    const auto more = textOf(part);
    if (!more) return std::nullopt;
    text += *more;
  }
  return text;
}

Claims::Why Claims::textOf(const MessagePart& part) const {
  if (part.terms.empty()) return part.text;
  auto sum = part.constant;
  for (const auto& [factor, watched] : part.terms) {
    const auto value = values.find(executable.system.watched[watched].display);
    if (value == values.end()) return std::nullopt;
    if (part.isValue) return value->second;
    std::int64_t number = 0;
    const auto& word = value->second;
    std::from_chars(word.data(), word.data() + word.size(), number);
    sum += factor * number;
  }
  return std::to_string(sum);
}

} // namespace proskill::runtime
