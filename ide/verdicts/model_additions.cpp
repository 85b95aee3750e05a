#include "ide/verdicts/model_additions.h"

#include "fiacre/print/print.h"
#include "fiacre/syntax/words.h"
#include "ide/verdicts/addition.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace proskill::ide {

namespace {

// --- Properties

/// The names that paths use for the parts of a model: the processes, with the program's names.
fiacre::PathSteps stepsOf(const codegen::Model& model) {
  fiacre::PathSteps steps;
  const auto& program = model.fiacre;
  const auto main = std::ranges::find(program.components, program.main, &fiacre::Component::name);
  if (main == program.components.end()) return steps;
  std::uint32_t place = 0;
  for (const auto& instance : main->instances) {
    steps.try_emplace(instance.process, ++place);
    const auto process =
        std::ranges::find(program.processes, instance.process, &fiacre::Process::name);
    if (process == program.processes.end()) continue;
    const auto& actor = model.provenance.origins[process->origin].actor;
    if (fiacre::isIdentifier(actor)) steps.try_emplace(actor, place);
  }
  return steps;
}

/// Translates names of the program to names of the model.
class Translation {
public:
  explicit Translation(const std::vector<fiacre::Watched>& known) : watched(known) {}

  void translate(fiacre::Expr& expr) const {
    if (const auto* variable = named(fiacre::printExpr(expr))) {
      expr = fiacre::parseExpr(variable->lvalue).value_or(expr);
      return;
    }
    const auto* compared =
        expr.operands.empty() ? nullptr : named(fiacre::printExpr(expr.operands[0]));
    for (auto& operand : expr.operands) translate(operand);
    if (!compared || expr.operands.size() != 2) return;
    auto& value = expr.operands[1];
    for (const auto& [inModel, inProgram] : compared->values)
      if (value.kind == fiacre::ExprKind::Name && value.name == inProgram) value.name = inModel;
  }

  void translate(fiacre::Observable& observable) const {
    if (observable.kind == fiacre::ObservableKind::Value && observable.path.empty())
      translate(observable.value);
    for (auto& operand : observable.operands) translate(operand);
  }

  void translate(fiacre::Ltl& ltl) const {
    translate(ltl.atom);
    for (auto& operand : ltl.operands) translate(operand);
  }

  void translate(fiacre::Pattern& pattern) const {
    for (auto& operand : pattern.operands) translate(operand);
    if (pattern.after) translate(*pattern.after);
    if (pattern.before) translate(*pattern.before);
    translate(pattern.ltl);
  }

private:
  [[nodiscard]] const fiacre::Watched* named(const std::string& text) const {
    const auto found = std::ranges::find_if(watched, [&](const fiacre::Watched& each) {
      return each.display == text || each.lvalue == text;
    });
    return found == watched.end() ? nullptr : &*found;
  }

  const std::vector<fiacre::Watched>& watched;
};

constexpr std::string_view kAnyModel = "model";

/// Paths begin with the model's name. Other declarations are not allowed here.
void checkProperties(Addition& addition) {
  const auto& text = addition.text();
  for (const auto& block : addition.parsed.blocks)
    if (block.kind != NameKind::Property)
      addition.complain({block.begin, block.end}, "properties",
                        "only properties can be added to a model");
  for (const auto& mention : addition.parsed.mentions) {
    const auto name = std::string_view(text).substr(mention.begin, mention.end - mention.begin);
    if (mention.kind == NameKind::Component && name != kAnyModel &&
        name != addition.model.fiacre.main)
      addition.complain({mention.begin, mention.end}, "properties",
                        fmt::format("the model is `{}`: a path begins with that, or with `{}`",
                                    addition.model.fiacre.main, kAnyModel));
  }
}

void addChecked(Addition& addition, fiacre::Property property) {
  auto& model = addition.model;
  const auto same = [&](const fiacre::Property& other) { return other.name == property.name; };
  if (std::ranges::any_of(model.fiacre.properties, same))
    return addition.complainAt(property.name, NameKind::Property, "property " + property.name,
                               "the model has a property of that name");
  Translation(model.provenance.watched).translate(property.pattern);
  if (property.asserted)
    model.checks.push_back(
        {.name = property.name,
         .kind = "property",
         .subject = property.name,
         .description = fiacre::printPattern(property.pattern, model.fiacre.main),
         .property = model.fiacre.properties.size(),
         .origin = property.origin});
  model.fiacre.properties.push_back(std::move(property));
}

/// Turns a formula without a name into a property with the file's name, at the same position.
std::string asProperty(const std::filesystem::path& path, const std::string& formula) {
  auto name = path.stem().string();
  std::ranges::replace_if(
      name, [](char c) { return !fiacre::isIdentifier(std::string("a") + c); }, '_');
  if (!fiacre::isIdentifier(name) || fiacre::isReserved(name)) name = "formula_" + name;
  return fmt::format("property {0} is ltl {1}\nassert {0}\n", name, formula);
}

} // namespace

std::vector<Diagnostic> addProperties(codegen::Model& model, analysis::Program& program,
                                      const std::filesystem::path& path, std::string text) {
  if (path.extension() == ".ltl") text = asProperty(path, text);
  Addition addition(model, program, path, std::move(text), stepsOf(model));
  checkProperties(addition);
  if (!addition.diagnostics.empty()) return addition.diagnostics;
  for (auto& property : addition.parsed.program.properties)
    addChecked(addition, std::move(property));
  if (addition.diagnostics.empty()) addition.check();
  return addition.diagnostics;
}

} // namespace proskill::ide
