#include "runtime/stubs/stubs.h"

#include "analysis/names/index.h"
#include "analysis/names/types.h"
#include "runtime/platform/messages.h"

#include <algorithm>

namespace proskill::runtime {

namespace {

/// Finds the actions of a program and their types.
class StubReader {
public:
  StubReader(const analysis::Program& of, StubProgram& to) : program(of), symbols(of), made(to) {}

  void add(const codegen::Performed& performed) {
    const auto& skill = *program.skills.find(performed.skill);
    StubAction action{.skill = performed.skill};
    for (const auto& result : performed.results) action.results.push_back(resultName(result));
    if (const auto& written = skill->action) {
      const auto text = program.files[skill.file].document.text();
      action.action = text.substr(written->range.begin, written->range.end - written->range.begin);
      for (const auto& argument : written->arguments)
        action.parameters.push_back(parameterOf(argument, *skill.form->as<syntax::Skill>()));
    }
    made.actions.push_back(std::move(action));
  }

private:
  StubAction::Parameter parameterOf(const syntax::Expr& argument, const syntax::Skill& skill) {
    using syntax::ExprKind;
    if (argument.kind == ExprKind::Parameter)
      for (const auto& input : skill.inputs)
        if (input.name.text == argument.name.text)
          return {std::string(input.name.text.substr(1)), typeOf(input.type.text)};
    if (argument.kind == ExprKind::True || argument.kind == ExprKind::False)
      return {"", {StubType::Kind::Boolean, ""}};
    if (argument.kind != ExprKind::Number) return {"", {StubType::Kind::String, ""}};
    const auto type = analysis::typeOfNumber(argument).kind;
    return {
        "",
        {type == analysis::TypeKind::Float ? StubType::Kind::Float : StubType::Kind::Integer, ""}};
  }

  StubType typeOf(std::string_view name) {
    using analysis::TypeKind;
    const auto type = analysis::typeNamed(program, symbols, name).kind;
    if (type == TypeKind::Boolean) return {StubType::Kind::Boolean, ""};
    if (type == TypeKind::Natural) return {StubType::Kind::Natural, ""};
    if (type == TypeKind::Integer) return {StubType::Kind::Integer, ""};
    if (type == TypeKind::Float) return {StubType::Kind::Float, ""};
    if (type != TypeKind::Value) return {StubType::Kind::String, ""};
    addVariable(name);
    return {StubType::Kind::Value, std::string(name)};
  }

  void addVariable(std::string_view name) {
    if (std::ranges::find(made.variables, name, &StubProgram::Variable::name) !=
        made.variables.end())
      return;
    auto& variable = made.variables.emplace_back();
    variable.name = name;
    for (const auto& value : program.stateVariables.find(name)->node().states)
      variable.values.emplace_back(value.text);
  }

  const analysis::Program& program;
  analysis::SymbolTable symbols;
  StubProgram& made;
};

} // namespace

std::expected<StubProgram, codegen::GenerationError> stubProgram(const analysis::Program& program,
                                                                 const std::string& mainSkill) {
  const auto model =
      codegen::generate(program, {.edition = codegen::Edition::Executed, .mainSkill = mainSkill});
  if (!model) return std::unexpected(model.error());
  StubProgram made;
  made.file = program.files.front().path.filename().generic_string();
  StubReader reader(program, made);
  for (const auto& performed : model->performed) reader.add(performed);
  for (const auto& signal : model->signals)
    (signal.interrupts ? made.interrupts : made.events).push_back(signal.name);
  return made;
}

} // namespace proskill::runtime
