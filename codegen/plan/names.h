#pragma once

#include "analysis/program/program.h"
#include "codegen/plan/plan.h"
#include "codegen/plan/unique_names.h"

#include <map>
#include <string>
#include <string_view>

namespace proskill::codegen {

/// The names of everything in the model. State variables, events and skills keep their names where
/// possible, in this order of priority; names that the generator adds are changed instead.
class Names {
public:
  Names(const analysis::Program& program, const GenerationPlan& plan);

  const std::string& variable(std::string_view sv) { return global.of("variable", sv); }
  const std::string& type(std::string_view sv) { return global.of("type", {"sv", sv}); }
  /// A value of an enumeration: its own name, or with its variable's name in front if another
  /// variable has the same value.
  const std::string& value(std::string_view sv, std::string_view value);
  const std::string& error(std::string_view sv) { return global.of("error", {sv, "error"}); }
  const std::string& event(std::string_view event) { return global.of("event", event); }
  const std::string& interruptPort(std::string_view skill) {
    return global.of("interrupt", {"interrupt", skill});
  }
  /// The constant for the index of a skill or branch in `skill[]`.
  const std::string& cell(std::string_view thread) { return global.of("cell", thread); }
  const std::string& used(std::string_view resource) {
    return global.of("used", {resource, "used"});
  }
  const std::string& outcome(std::string_view skill) {
    return global.of("outcome", {skill, "outcome"});
  }
  /// The variable in which a body keeps a field of its own last call: `patrol_landing_status`.
  const std::string& own(std::string_view thread, std::string_view skill, std::string_view field) {
    return global.of("own", {thread, skill, field});
  }
  /// The variable for an input, given with its `$`: `visit_place`.
  const std::string& input(std::string_view skill, std::string_view input) {
    return global.of("input", {skill, input.substr(1)});
  }
  /// A constructor of `skill_result`: `takeoff_success_at_altitude`.
  const std::string& result(std::string_view skill, std::string_view status, std::string_view tag) {
    return global.of("result", {skill, status, tag});
  }
  const std::string& process(std::initializer_list<std::string_view> parts) {
    return global.of("process", parts);
  }
  /// A task or function in C, or a port that C code offers.
  const std::string& foreign(std::initializer_list<std::string_view> parts) {
    return global.of("foreign", parts);
  }
  const std::string& tag(std::initializer_list<std::string_view> parts) {
    return tags.of("tag", parts);
  }
  const std::string& property(std::string_view preferred) {
    return properties.of("property", preferred);
  }

  [[nodiscard]] const std::vector<UniqueNames::Renaming>& renamings() const {
    return global.renamings();
  }

private:
  UniqueNames global;
  UniqueNames tags;
  UniqueNames properties;
  std::map<std::string_view, int> ownersOfValue; ///< number of variables that have this value
};

/// The text as part of an identifier: other characters become `_`.
[[nodiscard]] std::string sanitised(std::string_view text);

} // namespace proskill::codegen
