#include "runtime/conform/claims.h"

#include "runtime/executor/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

namespace proskill::runtime {

namespace {

class Claims {
public:
  Claims(const Executable& of, const RecordedRun& by) : executable(of), run(by) {}

  std::optional<Contradiction> first() {
    if (auto why = wrongInitial()) return Contradiction{0, std::move(*why)};
    auto call = run.calls.begin();
    for (std::size_t i = 0; i <= run.steps.size(); ++i) {
      for (; call != run.calls.end() && call->after <= i; ++call)
        if (auto why = wrongCall(*call)) return Contradiction{i, std::move(*why)};
      if (i == run.steps.size()) break;
      if (auto why = wrongMessage(run.steps[i])) return Contradiction{i, std::move(*why)};
      for (const auto& change : run.steps[i].changes) values[change.variable] = change.after;
    }
    return std::nullopt;
  }

private:
  using Why = std::optional<std::string>;

  Why wrongInitial() {
    if (run.initial.empty()) return std::nullopt;
    for (const auto& value : run.initial) values[value.variable] = value.after;
    const auto all = initialValues(executable);
    for (const auto& [variable, before, after] : all)
      if (const auto found = values.find(variable); found == values.end())
        return fmt::format("the recording has no initial value of `{}`", variable);
      else if (found->second != after)
        return fmt::format("`{}` begins with `{}`, not with `{}`", variable, after, found->second);
    if (values.size() == all.size()) return std::nullopt;
    return "the recording has initial values of variables that the program does not have";
  }

  /// An action starts in a step of its skill, with arguments that some call gives.
  [[nodiscard]] Why wrongCall(const RecordedCall& call) const {
    const auto* step = call.after == 0 ? nullptr : &run.steps[call.after - 1];
    if (!step || step->what.actor != call.skill || step->date != call.date)
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

  [[nodiscard]] Why wrongMessage(const RecordedStep& step) const {
    const auto& origins = executable.model.provenance.origins;
    for (const auto& [id, message] : executable.messages)
      if (origins[id].actor == step.what.actor && origins[id].file == step.what.file &&
          origins[id].begin == step.what.begin && origins[id].end == step.what.end) {
        const auto text = textOf(message);
        if (!text || step.message == text) return std::nullopt;
        return fmt::format("this step prints \"{}\"", *text);
      }
    if (step.message.empty()) return std::nullopt;
    return "this step prints nothing";
  }

  /// A message with the values that the recording has; nullopt if it lacks one of them.
  [[nodiscard]] Why textOf(const std::vector<MessagePart>& message) const {
    std::string text;
    for (const auto& part : message) {
      const auto more = textOf(part);
      if (!more) return std::nullopt;
      text += *more;
    }
    return text;
  }

  [[nodiscard]] Why textOf(const MessagePart& part) const {
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

  const Executable& executable;
  const RecordedRun& run;
  std::map<std::string, std::string> values; ///< by variable, before the step
};

} // namespace

std::optional<Contradiction> contradiction(const Executable& executable, const RecordedRun& run) {
  return Claims(executable, run).first();
}

} // namespace proskill::runtime
