#include "fiacre/print/print.h"
#include "verify/export/asked.h"
#include "verify/export/export.h"
#include "verify/export/promela_model.h"
#include "verify/export/promela_step.h"
#include "verify/export/symbolic_step.h"
#include "verify/limits.h"
#include "verify/unsupported.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace proskill::verify {

namespace {

/// A text without what would end a comment.
std::string comment(std::string text) {
  for (std::size_t at = 0; (at = text.find("*/", at)) != std::string::npos;)
    text.replace(at, 2, "* /");
  std::ranges::replace(text, '\n', ' ');
  return text;
}

constexpr auto kHead = R"(/* Made by `proskill emit promela` of {}, for Spin.
   Verdicts:  spin -a FILE && gcc -O2 -DSAFETY -DNOREDUCE -o pan pan.c && ./pan -c0 -e -E
   Counts:    spin -a -o1 -o2 -DCOUNTS FILE && gcc -O2 -DSAFETY -DNOREDUCE -o pan pan.c && ./pan -E
   Spin counts the states of the model{} and their transitions, and the initial state as one more transition.
)";

constexpr auto kMacros = R"(*/

#ifdef COUNTS
#define expect(p, condition) skip
#else
#define expect(p, condition) if :: p && !(condition) -> p = false; assert(p) :: else fi
#endif

)";

class PromelaWriter {
public:
  PromelaWriter(const fiacre::Program& of, PromelaModel& in) : program(of), model(in) {}

  std::string write(const std::vector<std::string>& notes) {
    text = fmt::format(kHead, comment(program.main), model.timed ? ", with its clocks" : "");
    writeNotes(notes);
    text += kMacros;
    writeAssertions();
    writeVariables();
    writeMacros();
    text += "\nactive proctype model() {\n";
    writeStart();
    text += "  do\n";
    for (TransitionId i = 0; i < model.system.transitions.size(); ++i) writeStep(i);
    if (model.timed) text += promelaTick(model);
    if (model.mayFail) text += "  :: failed -> break\n";
    if (model.system.transitions.empty()) text += "  :: false -> skip\n"; // a loop has an option
    writeDeadlocks();
    text += "  od\n}\n";
    return std::move(text);
  }

private:
  void writeNotes(const std::vector<std::string>& notes) {
    for (const auto& note : notes) text += fmt::format("   Note: {}.\n", comment(note));
  }

  void writeAssertions() {
    bool ofErrors = false;
    for (const auto& assertion : model.assertions) {
      ofErrors = ofErrors || assertion.goal->kind == GoalKind::Error;
      text += fmt::format("hidden byte {} = true; /* {} */\n", assertion.name,
                          comment(assertion.question));
    }
    if (model.mayFail && !ofErrors) text += "hidden byte no_error = true;\n";
  }

  void writeVariables() {
    std::vector<const Instance*> instanceAt(model.system.cells.size());
    for (const auto& instance : model.system.instances) instanceAt[instance.location] = &instance;
    for (CellId i = 0; i < model.system.cells.size(); ++i) {
      const Cell& cell = model.system.cells[i];
      text += fmt::format("{} {} = {};", promelaType(cell.low, cell.high), model.names.cell(i),
                          cell.initial);
      if (instanceAt[i]) text += fmt::format(" /* {} */", locations(*instanceAt[i]));
      text += '\n';
    }
    for (ClockId i = 0; i < model.system.clocks.size(); ++i)
      text += fmt::format("{} {} = 0;\n", promelaType(0, model.time.most()[i] + 1),
                          model.names.clock(i));
    if (model.mayFail) text += "bool failed = false;\nhidden int turns;\n";
    writeHidden();
  }

  /// They are set before they are read in each step, so they distinguish no states.
  void writeHidden() {
    model.events.each(
        [&](EventId event) { text += fmt::format("hidden byte {};\n", model.names.event(event)); });
    model.kept.each(
        [&](CellId cell) { text += fmt::format("hidden int {};\n", model.names.before(cell)); });
    for (std::size_t i = 0; i < model.temporaries; ++i) text += fmt::format("hidden int n{};\n", i);
  }

  static std::string locations(const Instance& instance) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < instance.locations.size(); ++i)
      all.push_back(fmt::format("{} {}", i, instance.locations[i]));
    return comment(fmt::format("{}", fmt::join(all, ", ")));
  }

  void writeMacros() {
    for (auto id : model.named) {
      const Transition transition = model.system.transitions[id];
      const auto enabled = withPlace(transition, [&] {
        return model.names.text(enabledNode(model.system, transition, model.nodes, model.faults));
      });
      text += fmt::format("#define {} ({})\n", model.names.enabled(id), enabled);
    }
    text += clockMacros(model);
    if (!model.mayFail) return;
    text += "#define fail_run failed = true";
    bool asked = false;
    for (const auto& assertion : model.assertions)
      if (assertion.goal->kind == GoalKind::Error) {
        text += fmt::format("; expect({}, false)", assertion.name);
        asked = true;
      }
    text += asked ? "\n" : "; expect(no_error, false)\n";
  }

  void writeStart() {
    std::vector<std::string> checks;
    for (const auto& assertion : model.assertions) {
      if (assertion.goal->kind == GoalKind::Events && assertion.goal->initially)
        checks.push_back(fmt::format("expect({}, false)", assertion.name));
      if (auto check = assertedOfState(model, assertion)) checks.push_back(std::move(*check));
    }
    if (!checks.empty())
      text += fmt::format("#ifndef COUNTS\n  d_step {{ {} }}\n#endif\n", fmt::join(checks, "; "));
  }

  void writeStep(TransitionId id) {
    const Transition transition = model.system.transitions[id]; // nodes are added
    std::vector<std::string> who;
    for (auto part : transition.parts) {
      const Path& path = model.system.paths[part];
      const auto& instance = model.system.instances[path.instance];
      who.push_back(instance.name + " from " + instance.locations[path.location]);
    }
    text += fmt::format("  /* {}: {}", id, comment(fmt::format("{}", fmt::join(who, ", "))));
    if (transition.port != kNone) text += comment(" on " + model.system.ports[transition.port]);
    if (model.timed) text += comment(" " + fiacre::printInterval(transition.interval));
    text += " */\n";
    text += withPlace(transition, [&] { return promelaStep(model, id); });
  }

  /// An error has the place of the step.
  template <class Make> std::string withPlace(const Transition& transition, const Make& make) {
    try {
      return make();
    } catch (CompileError& error) {
      if (error.why.origin == 0) error.why.origin = model.system.paths[transition.parts[0]].origin;
      throw;
    }
  }

  /// Where no step is possible, Spin's `timeout` is.
  void writeDeadlocks() {
    std::vector<std::string> checks;
    for (const auto& assertion : model.assertions)
      if (assertion.goal->kind == GoalKind::Deadlock)
        checks.push_back(
            fmt::format("expect({}, {})", assertion.name, model.names.text(assertion.condition)));
    if (!checks.empty())
      text += fmt::format("#ifndef COUNTS\n  :: timeout -> d_step {{ {} }}\n#endif\n",
                          fmt::join(checks, "; "));
  }

  const fiacre::Program& program;
  PromelaModel& model;
  std::string text;
};

std::vector<std::string> notesOn(const PromelaModel& model, const Compiled& compiled,
                                 const std::vector<std::string>& names) {
  std::vector<std::string> notes;
  if (model.timed)
    notes.push_back(fmt::format("time is discrete: one tick is {}{} unit(s) of the model",
                                model.time.unit(), model.time.isExact() ? "" : "/2"));
  if (model.timed && !model.time.isExact())
    notes.emplace_back("with open bounds, not every state is reached in discrete time: what Spin "
                       "finds can happen, but what it does not find may happen, too");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const auto why = whyNotAsked(compiled.goals[i]))
      notes.push_back(fmt::format("Spin is not asked for `{}`: {}", names[i], *why));
  return notes;
}

} // namespace

std::expected<Exported, Unsupported> exportPromela(const fiacre::Program& program,
                                                   const fiacre::Provenance& provenance,
                                                   const std::vector<Question>& questions,
                                                   const std::vector<std::string>& names,
                                                   const Options& options) try {
  LimitWatch limits(options);
  auto compiled = compile(program, provenance, questions, &limits);
  if (!compiled) return std::unexpected(compiled.error());
  PromelaModel model(*compiled, names);
  Exported made;
  made.notes = notesOn(model, *compiled, names);
  made.text = PromelaWriter(program, model).write(made.notes);
  return made;
} catch (const CompileError& error) {
  return std::unexpected(error.why);
} catch (const LimitMet& limit) {
  return std::unexpected(Unsupported{limit.which});
}

} // namespace proskill::verify
