#pragma once

#include "codegen/model.h"
#include "codegen/plan/call_table.h"
#include "codegen/plan/names.h"
#include "codegen/plan/origins.h"
#include "codegen/plan/plan.h"
#include "codegen/term/build.h"
#include "codegen/term/times.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::codegen {

/// What a word or a parameter of a condition refers to.
struct Operand {
  std::string variable;                        ///< of the model
  const syntax::StateVariable* type = nullptr; ///< whose values it has; null: it is a truth value
};

/// The input of all parts of the generator: the program, the plan, and results that parts pass to
/// each other.
struct Context {
  const analysis::Program& program;
  const Options& options;
  GenerationPlan plan;
  Times times;
  Names names;
  Origins origins;
  std::vector<std::string> results;   ///< used constructors of `skill_result`, except `no_result`
  std::set<std::string_view> alarmed; ///< state variables with a move that may be forbidden
  std::optional<fiacre::Function> invariantActive; ///< if any skill has an invariant
  std::string_view reader;              ///< the thread whose conditions are being translated
  const SkillPlan* writtenIn = nullptr; ///< the skill whose text is being translated
  CallTable arguments;                  ///< for the runtime and executed editions
  std::vector<Performed> performed;
  std::map<fiacre::OriginId, Alarm> alarms; ///< filled while the model is built
  std::map<fiacre::OriginId, std::vector<MessagePart>> messages; ///< likewise

  [[nodiscard]] bool isRuntime() const { return options.edition == Edition::Runtime; }
  [[nodiscard]] bool isExecuted() const { return options.edition == Edition::Executed; }
  /// Whether a platform performs the actions, so that their arguments are needed.
  [[nodiscard]] bool isPerformed() const { return isRuntime() || isExecuted(); }
  /// Whether events and interrupts from outside happen in the model itself.
  [[nodiscard]] bool hasEnvironment() const {
    return !isPerformed() || (isExecuted() && options.environment);
  }
  /// Whether every state is named, not only those in which time passes.
  [[nodiscard]] bool isExpanded() const {
    return options.edition != Edition::Compact && !isExecuted();
  }

  /// Whether some variable has several initial values.
  [[nodiscard]] bool hasInitialChoice() const {
    const auto& all = program.stateVariables.all;
    return std::ranges::any_of(all, [](const auto& each) { return !each->otherInits.empty(); });
  }

  [[nodiscard]] const syntax::StateVariable& stateVariable(std::string_view name) const {
    return program.stateVariables.find(name)->node();
  }
  /// For the comment above a definition of the model.
  template <class Node>
  [[nodiscard]] std::string definitionOf(const analysis::Definition<Node>& definition) const {
    return origins.definition(definition.file, *definition.form, definition.name());
  }
  [[nodiscard]] std::int64_t capacity(std::string_view resource) const {
    const auto& capacity = program.resources.find(resource)->node().capacity;
    return capacity ? capacity->number.numerator : 1;
  }
  /// A state variable, or an input of the skill that is being translated; nullopt for others.
  [[nodiscard]] std::optional<Operand> operand(const syntax::Expr& expr);
  /// The state variable whose values an input has; null: it is a truth value.
  [[nodiscard]] const syntax::StateVariable* typeOf(const syntax::Input& input) const;
  /// A field of a skill or a branch: `skill[takeoff].status`.
  [[nodiscard]] fiacre::Expr cellField(std::string_view thread, std::string_view field);
  /// `status` or `val` of a skill as the body `reader` sees it: of its own last call if several
  /// processes call the skill. Without a reader: of the last call by anybody.
  [[nodiscard]] fiacre::Expr outcomeField(std::string_view skill, std::string_view field);
  /// The variable in which a thread keeps `status` or `val` of its own last call.
  [[nodiscard]] fiacre::Expr ownField(std::string_view thread, std::string_view skill,
                                      std::string_view field);
  /// A constructor of `skill_result`. Records that it is used.
  [[nodiscard]] fiacre::Expr result(std::string_view skill, std::string_view status,
                                    std::string_view tag);
};

/// As long as it lives, the text of this skill is being translated.
class WrittenIn {
public:
  WrittenIn(Context& context, const SkillPlan& skill)
      : context(context), before(context.writtenIn) {
    context.writtenIn = &skill;
  }
  ~WrittenIn() { context.writtenIn = before; }
  WrittenIn(const WrittenIn&) = delete;
  WrittenIn& operator=(const WrittenIn&) = delete;

private:
  Context& context;
  const SkillPlan* before;
};

/// The actor of a skill, or of one of its threads, in traces.
[[nodiscard]] Actor actorOf(const SkillPlan& skill);
[[nodiscard]] Actor actorOf(const SkillPlan& skill, const BodyAutomaton& thread);

} // namespace proskill::codegen
