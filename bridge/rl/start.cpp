#include "bridge/rl/translate.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::bridge::rl {
namespace {

constexpr std::ptrdiff_t kMostTruths = 4; // each doubles the calls

/// Writes the calls of a composite with each combination of truth values.
class Start {
public:
  Start(const Callable& composite, NamePool& names) : composite(composite), names(names) {}

  Block program() {
    const auto name = names.take("start_" + composite.name);
    auto body = calls(0, {});
    Form failed = list("if", list("/=", composite.name + ".status", "success"));
    failed.parts.push_back(list("failure", "failed"));
    append(body, {failed, list("success", "done")});
    variables.push_back(list("defskill", name, ":success", "done", ":failure", "failed", ":body",
                             Form(std::move(body))));
    return variables;
  }

private:
  Block calls(std::size_t input, const Block& given) {
    if (input == composite.inputs.size()) {
      Form call = list(composite.name);
      append(call.parts, given);
      return {call};
    }
    const auto with = [&](Form value) {
      auto more = given;
      append(more, {composite.inputs[input], std::move(value)});
      return calls(input + 1, more);
    };
    const auto& type = composite.types[input];
    if (type == "string") return with(asString(composite.inputs[input]));
    if (type != "bool") return with("0");
    Form choice = list("if", list(truth(composite.inputs[input]), "Yes"));
    append(choice.parts, with("true"));
    choice.parts.emplace_back("else");
    append(choice.parts, with("false"));
    return {choice};
  }

  /// A variable that has one value for ever, which may be either.
  std::string truth(const std::string& input) {
    auto& name = truths[input];
    if (!name.empty()) return name;
    name = names.take(composite.name + "_" + input);
    variables.push_back(
        list("defsv", name, ":states", list("Yes", "No"), ":init", list("Yes", "No")));
    return name;
  }

  const Callable& composite;
  NamePool& names;
  Block variables;
  std::map<std::string, std::string> truths; ///< by input
};

} // namespace

std::expected<Block, std::string> startOf(const Callable& composite, NamePool& names) {
  if (std::ranges::count(composite.types, "bool") > kMostTruths)
    return std::unexpected(
        fmt::format("nothing calls `{}`, which has more than {} parameters of type `bool`",
                    composite.name, kMostTruths));
  return Start(composite, names).program();
}

} // namespace proskill::bridge::rl
