#include "runtime/stubs/hippo.h"

#include "fiacre/print/print.h"
#include "runtime/stubs/platform_header.h"
#include "runtime/stubs/stub_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::runtime {

namespace {

constexpr std::string_view kAction = "_action";
constexpr std::string_view kInterrupt = "_interrupt_action";

/// Writes what connects the functions of the model with those of the actions.
class HippoGlue {
public:
  HippoGlue(const StubProgram& of, const codegen::Model& executed, codegen::Model& hippo)
      : program(of), performed(executed.performed), model(hippo) {
    for (const auto& task : model.fiacre.tasks) bases.push_back(baseOf(task.function, kAction));
    for (const auto& type : model.fiacre.types)
      if (type.name == "skill_result")
        for (const auto& member : type.type.members) members.push_back(member.name);
  }

  /// Lets the model announce each start of an action that can be stopped, so that a stop that
  /// overtakes the task's thread is not lost.
  void announceStarts() {
    const auto externs = model.fiacre.externs;
    for (const auto& each : externs) {
      const auto base = baseOf(each.function, kInterrupt);
      const auto action = actionWith(base);
      auto begin = each;
      begin.name = fmt::format("Fiacre_{}_begin", base);
      begin.function = base + "_begin";
      for (auto& process : model.fiacre.processes)
        for (auto& from : process.transitions)
          announce(from.statement, model.fiacre.tasks[action].name, begin.name);
      model.fiacre.externs.push_back(std::move(begin));
    }
  }

  [[nodiscard]] std::string text() const {
    std::string text = "#include \"hippo_host.h\"\n#include \"hippo_types.h\"\n\n"
                       "#include <string.h>\n";
    text += lists();
    for (std::size_t i = 0; i < program.actions.size(); ++i) text += task(i);
    for (const auto& each : model.fiacre.externs) text += function(each.function);
    for (std::size_t i = 0; i < model.fiacre.eventPorts.size(); ++i)
      text += fmt::format("\nvoid {0}(void);\nvoid {0}(void) {{ hippo_await_event({1}); }}\n",
                          model.fiacre.eventPorts[i].function, i);
    return text;
  }

private:
  static std::string baseOf(const std::string& function, std::string_view suffix) {
    return function.ends_with(suffix) ? function.substr(0, function.size() - suffix.size())
                                      : function;
  }

  [[nodiscard]] std::size_t actionWith(const std::string& base) const {
    return static_cast<std::size_t>(std::ranges::find(bases, base) - bases.begin());
  }

  static void announce(fiacre::Statement& statement, const std::string& task,
                       const std::string& begin) {
    for (auto& child : statement.children) announce(child, task, begin);
    if (statement.kind != fiacre::StatementKind::Start || statement.name != task) return;
    fiacre::Statement assign;
    assign.kind = fiacre::StatementKind::Assign;
    fiacre::Expr target;
    target.kind = fiacre::ExprKind::Name;
    target.name = "ignoreb";
    fiacre::Expr call;
    call.kind = fiacre::ExprKind::Construct;
    call.name = begin;
    assign.targets.push_back(std::move(target));
    assign.values.push_back(std::move(call));
    fiacre::Statement both;
    both.kind = fiacre::StatementKind::Sequence;
    both.children = {std::move(assign), std::move(statement)};
    statement = std::move(both);
  }

  /// Names by number: of skills, and of event ports.
  [[nodiscard]] std::string lists() const {
    std::string skills;
    for (const auto& action : program.actions) skills += fmt::format("\"{}\", ", action.skill);
    std::string events;
    for (const auto& port : model.fiacre.eventPorts)
      events += fmt::format("\n    \"{}\",", eventName(port.function));
    return fmt::format("\nconst char *const hippo_skills[] = {{{}NULL}};\n"
                       "const size_t hippo_skill_count = {};\n"
                       "const char *const hippo_events[] = {{{}\n    NULL}};\n"
                       "const size_t hippo_event_count = {};\n",
                       skills, program.actions.size(), events, model.fiacre.eventPorts.size());
  }

  /// The name by which actions report an event; `interrupt fly` for an interrupt from outside.
  [[nodiscard]] std::string eventName(const std::string& function) const {
    for (const auto& event : program.events)
      if (function == "c_" + event) return event;
    for (const auto& skill : program.interrupts)
      if (function == "c_interrupt_" + skill) return "interrupt " + skill;
    return function;
  }

  [[nodiscard]] std::string function(const std::string& name) const {
    const bool stops = name.ends_with(kInterrupt);
    const auto action = actionWith(baseOf(name, stops ? kInterrupt : "_begin"));
    return fmt::format("\nbool {0}(void);\nbool {0}(void) {{\n  {1}({2});\n  return true;\n}}\n",
                       name, stops ? "hippo_stop" : "hippo_begin", action);
  }

  [[nodiscard]] std::string task(std::size_t action) const {
    const auto& of = program.actions[action];
    const auto count = of.parameters.size();
    auto text = fmt::format("\nconst char *skill_{}(proskill_run run, const proskill_value "
                            "*arguments, size_t count);\n",
                            of.skill);
    if (count > 0) text += arguments(action);
    text += fmt::format("\nhippo_result {0}(hippo_record skill);\n"
                        "hippo_result {0}(hippo_record skill) {{\n",
                        model.fiacre.tasks[action].function);
    text += count > 0
                ? fmt::format("  const proskill_value *arguments = {}_arguments[skill.ArgIndex"
                              "];\n",
                              of.skill)
                : "  const proskill_value *arguments = NULL;\n  (void)skill;\n";
    if (!canBeStopped(action)) text += fmt::format("  hippo_begin({});\n", action);
    text += fmt::format("  const char *result = hippo_perform({}, skill_{}, arguments, {});\n",
                        action, of.skill, count);
    for (std::size_t i = 0; i < of.results.size(); ++i)
      text += fmt::format("  if (result && strcmp(result, \"{}\") == 0) return {}; // {}\n",
                          of.results[i], position(memberFor(action, i)), memberFor(action, i));
    const auto none = of.skill + "_interrupted";
    return text + fmt::format("  return {}; // {}\n}}\n", position(none), none);
  }

  [[nodiscard]] bool canBeStopped(std::size_t action) const {
    return std::ranges::any_of(model.fiacre.externs, [&](const fiacre::Extern& each) {
      return each.function == bases[action] + std::string(kInterrupt);
    });
  }

  /// The member of skill_result for a result of an action.
  [[nodiscard]] std::string memberFor(std::size_t action, std::size_t result) const {
    const auto& [status, tag, port] = performed[action].results[result];
    return fmt::format("{}_{}{}{}", program.actions[action].skill, status, tag.empty() ? "" : "_",
                       tag);
  }

  [[nodiscard]] std::ptrdiff_t position(const std::string& member) const {
    const auto found = std::ranges::find(members, member);
    return found == members.end() ? 0 : found - members.begin();
  }

  /// The arguments of all calls of a skill, by its ArgIndex.
  [[nodiscard]] std::string arguments(std::size_t action) const {
    const auto& of = program.actions[action];
    const auto count = of.parameters.size();
    std::size_t calls = 1;
    for (const auto& call : model.actionCalls)
      if (call.skill == of.skill)
        calls = std::max(calls, static_cast<std::size_t>(call.number) + 1);
    auto text = fmt::format("\nstatic const proskill_value {}_arguments[{}][{}] = {{\n", of.skill,
                            calls, count);
    for (const auto& call : model.actionCalls) {
      if (call.skill != of.skill) continue;
      text += fmt::format("    [{}] = {{", call.number);
      for (std::size_t i = 0; i < count; ++i)
        text += (i > 0 ? ", " : "") +
                value(of.parameters[i].type, i < call.arguments.size() ? call.arguments[i] : "");
      text += "},\n";
    }
    return text + "};\n";
  }

  [[nodiscard]] static std::string value(const StubType& type, std::string literal) {
    if (literal.empty()) return "{PROSKILL_NONE, 0, 0, \"\"}";
    switch (type.kind) {
    case StubType::Kind::Integer:
    case StubType::Kind::Natural:
      return fmt::format("{{PROSKILL_INTEGER, {0}, {0}, \"\"}}", literal);
    case StubType::Kind::Float: return fmt::format("{{PROSKILL_FLOAT, 0, {}, \"\"}}", literal);
    case StubType::Kind::Boolean:
      return fmt::format("{{PROSKILL_BOOLEAN, {}, 0, \"\"}}", literal == "true" ? 1 : 0);
    case StubType::Kind::String:
    case StubType::Kind::Value:
      if (!literal.starts_with('"')) literal = "\"" + literal + "\"";
      return fmt::format("{{PROSKILL_STRING, 0, 0, {}}}", literal);
    }
    return "";
  }

  const StubProgram& program;
  const std::vector<codegen::Performed>& performed;
  codegen::Model& model;
  std::vector<std::string> bases;   ///< by action: of the names of its functions
  std::vector<std::string> members; ///< of the union skill_result
};

std::string makefile(std::int64_t ticksPerSecond) {
  return fmt::format(
      "# Makes the executable `mission`. This file is yours.\n"
      "# HIPPO is the directory of Hippo's hippo.c and hippo.h, FRAC2HIPPO its frac.\n"
      "HIPPO ?= /usr/local/lib/hippo\n"
      "FRAC2HIPPO ?= frac2hippo\n"
      "CFLAGS ?= -O2 -Wall\n"
      "# A tick is so many nanoseconds.\n"
      "TICK = {}\n\n"
      "sources = main.c robot.c actions.c hippo_glue.c hippo_host.c\n\n"
      "mission: $(sources) model.hippo\n"
      "\t$(CC) $(CFLAGS) -std=gnu11 -DPOSIX -D_TICK_UNIT_=$(TICK) -I. -I$(HIPPO) -Imodel.hippo -o "
      "$@ \\\n"
      "\t  $(sources) $(HIPPO)/hippo.c $(wildcard model.hippo/*.c) -lpthread -lrt\n\n"
      "model.hippo: mission.fcr\n"
      "\t$(FRAC2HIPPO) mission.fcr model.hippo/\n",
      1'000'000'000 / ticksPerSecond);
}

} // namespace

std::expected<std::vector<StubFile>, codegen::GenerationError>
hippoProject(const analysis::Program& program, const std::string& mainSkill,
             std::int64_t ticksPerSecond) {
  const auto stubs = stubProgram(program, mainSkill);
  if (!stubs) return std::unexpected(stubs.error());
  const auto executed =
      codegen::generate(program, {.edition = codegen::Edition::Executed, .mainSkill = mainSkill});
  if (!executed) return std::unexpected(executed.error());
  auto model = codegen::generate(program, {.edition = codegen::Edition::Runtime,
                                           .mainSkill = mainSkill,
                                           .ticksPerSecond = ticksPerSecond});
  if (!model) return std::unexpected(model.error());
  HippoGlue glue(*stubs, *executed, *model);
  glue.announceStarts();
  std::vector<StubFile> files;
  for (auto& file : cStubs(*stubs))
    if (file.name != "Makefile" && file.name != "platform.json") files.push_back(std::move(file));
  files.push_back({"mission.fcr", withStubMark("//", fiacre::print(model->fiacre)), false});
  files.push_back({"hippo_glue.c", withStubMark("//", glue.text()), false});
  files.push_back({"hippo_host.h", withStubMark("//", header::hostH), false});
  files.push_back({"hippo_host.c", withStubMark("//", header::hostC), false});
  files.push_back({"hippo_types.h", std::string(header::typesTxt), true});
  files.push_back({"main.c", std::string(header::mainC), true});
  files.push_back({"Makefile", makefile(ticksPerSecond), true});
  return files;
}

} // namespace proskill::runtime
