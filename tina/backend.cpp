#include "tina/backend.h"

#include "fiacre/print/print.h"
#include "tina/guide.h"
#include "tina/outputs.h"
#include "tina/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace proskill::tina {

namespace {

using fiacre::PatternKind;
using verify::Answer;
using verify::Truth;

bool prefers(const fiacre::Statement& statement) {
  return !statement.priorityGroups.empty() || std::ranges::any_of(statement.children, prefers);
}

/// With priorities, only strong state classes have exactly the runs of the model.
bool hasPriorities(const fiacre::Program& program) {
  const auto inProcess = [](const fiacre::Process& process) {
    return std::ranges::any_of(process.transitions,
                               [](const auto& from) { return prefers(from.statement); });
  };
  return !program.observers.empty() || std::ranges::any_of(program.processes, inProcess) ||
         std::ranges::any_of(program.components, [](const fiacre::Component& component) {
           return !component.priorities.empty();
         });
}

/// By default frac ignores observers and probes.
bool isObserved(const fiacre::Program& program) {
  const auto probed = [](const fiacre::Component& component) {
    return std::ranges::any_of(component.ports,
                               [](const fiacre::Port& port) { return port.probe.has_value(); });
  };
  return !program.observers.empty() || std::ranges::any_of(program.components, probed);
}

/// The model with the requested properties only: frac would also observe the rest.
fiacre::Program asking(fiacre::Program program, const std::vector<verify::Question>& questions) {
  std::vector<fiacre::Property> asked;
  for (const auto& question : questions) {
    asked.push_back(program.properties[question.property]);
    asked.back().asserted = true;
  }
  program.properties = std::move(asked);
  return program;
}

/// Whether the property asks for a deadlock while some are allowed. Fiacre can ask only for any
/// deadlock.
bool allowsSomeStops(const fiacre::Property& property) {
  return property.pattern.kind == PatternKind::DeadlockFree && !property.pattern.operands.empty();
}

class Backend {
public:
  Backend(const fiacre::Program& of, const fiacre::Provenance& from,
          const std::vector<verify::Question>& all, const Options& with, const Workspace& in)
      : program(of),
        provenance(from),
        questions(all),
        options(with),
        workspace(in),
        session(in, with) {}

  std::expected<Outcome, Failure> run() {
    outcome.result.answers.resize(questions.size());
    choose();
    outcome.model = fiacre::print(asking(program, asked));
    if (auto problem = workspace.write("model.fcr", outcome.model)) return fail(*problem);
    auto stop = build();
    if (!stop) stop = decide();
    if (!stop) stop = trace();
    outcome.result.exploration.seconds = session.seconds();
    if (stop && !stop->isLimit) return fail(stop->message);
    if (stop) leaveOpen(stop->message);
    outcome.calls = std::move(session.calls);
    return std::move(outcome);
  }

private:
  using Stop = Session::Stop;

  std::unexpected<Failure> fail(std::string message) {
    return std::unexpected(
        Failure{std::move(message), std::move(outcome.model), std::move(session.calls)});
  }

  void leaveOpen(const std::string& reason) {
    for (auto& answer : outcome.result.answers)
      if (answer.truth == Truth::Unknown && answer.reason.empty()) answer.reason = reason;
    outcome.result.exploration.complete = false;
    outcome.result.exploration.stopped = reason;
  }

  /// Orders the questions like the formulas that frac writes: as in the text.
  void choose() {
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const auto& property = program.properties[questions[i].property];
      if (!fiacre::isOfFiacre(property.pattern.kind))
        outcome.result.answers[i].reason = "Fiacre cannot express this property";
      else if (questions[i].fair)
        outcome.result.answers[i].reason = "Tina cannot exclude unfair runs; with `:fair nil` or "
                                           "`--runs all` it considers all of them";
      else
        order.push_back(i);
    }
    std::ranges::sort(order, {}, [&](std::size_t i) { return questions[i].property; });
    for (auto i : order) asked.push_back(questions[i]);
  }

  /// Generates the state graph and the formulas.
  std::optional<Stop> build() {
    const auto& tools = options.tools;
    std::vector<std::string> command{tools.frac, "model.fcr", "model.tts"};
    if (isObserved(program)) command.insert(command.begin() + 1, "-obs");
    if (auto done = session.run("frac", std::move(command)); !done) return done.error();
    const auto text = workspace.read("model.tts/model.ltl");
    if (!text) return Stop{false, "`frac` wrote no formulas: model.tts/model.ltl is missing"};
    formulas = readLtl(*text);
    if (formulas.queries.size() != asked.size())
      return Stop{false, fmt::format("`frac` wrote {} formulas for {} properties:\n{}",
                                     formulas.queries.size(), asked.size(), *text)};
    const std::string include = "-I" + tools.fraclib.string();
    if (auto done =
            session.run("cc", {tools.cc, "-O2", "-shared", "-fPIC", include, include + "/avl", "-o",
                               "model.tts/model.so", "model.tts/model.c"});
        !done)
      return done.error();
    return explore();
  }

  std::optional<Stop> explore() {
    const std::string name = options.tools.builder.filename();
    std::vector<std::string> command{options.tools.builder, hasPriorities(program) ? "-S" : "-W"};
    if (options.limits.classes) {
      command.emplace_back("-c");
      command.push_back(std::to_string(*options.limits.classes));
    }
    command.insert(command.end(), {"model.tts", "model.ktz"});
    const auto done = session.run(name, std::move(command));
    if (!done) return done.error();
    const auto counts = readCounts(done->out + done->err);
    if (saysUnfinished(done->out + done->err))
      return Stop{false, fmt::format("`{}` did not explore the whole graph", name)};
    if (!counts)
      return Stop{false, fmt::format("the output of `{}` on its graph is not understood", name)};
    outcome.result.exploration = *counts;
    const auto most = options.limits.classes;
    if (most && counts->classes >= *most) return Stop{true, "the limit of classes was reached"};
    return std::nullopt;
  }

  std::optional<Stop> decide() {
    if (order.empty()) return std::nullopt;
    const auto done =
        session.run("selt", {options.tools.selt, "-q", "-b", "model.ktz", "model.tts/model.ltl"});
    if (!done) return done.error();
    const auto verdicts = readVerdicts(done->out, order.size());
    if (!verdicts)
      return Stop{false, fmt::format("the verdicts of `selt` on {} formulas are not understood",
                                     order.size())};
    for (std::size_t k = 0; k < order.size(); ++k) note(k, (*verdicts)[k]);
    return std::nullopt;
  }

  /// Runs of Tina end only where no step is possible.
  void note(std::size_t k, bool isTrue) {
    auto& answer = answerOf(k);
    answer.truth = isTrue ? Truth::True : Truth::False;
    if (!isTrue || !asked[k].rests) return;
    answer.truth = Truth::Unknown;
    answer.reason = "it holds in the runs that Tina considers, in which an action without a time "
                    "limit does not last for ever";
  }

  /// Finds traces of false formulas. A missing trace does not invalidate a verdict, unless the
  /// engine has to decide whether the deadlock is allowed.
  std::optional<Stop> trace() {
    auto made = Guide::make(program, provenance, asked);
    constexpr std::ptrdiff_t kMany = 8; // each costs a run of selt; the graph is read once
    const bool manyAreFalse =
        std::ranges::count(outcome.result.answers, Truth::False, &Answer::truth) > kMany;
    for (std::size_t k = 0; k < order.size(); ++k) {
      if (answerOf(k).truth != Truth::False) continue;
      if (!made) {
        answerOf(k).reason = "no trace: the engine cannot read the model: " + made.error().message;
        continue;
      }
      const bool mayBeAllowed = allowsSomeStops(program.properties[asked[k].property]);
      if (mayBeAllowed) answerOf(k).truth = Truth::Unknown;
      const bool bySearch = mayBeAllowed || (manyAreFalse && (*made)->judges(k));
      if (auto stop = bySearch ? searched(**made, k) : witness(**made, k)) return stop;
    }
    return std::nullopt;
  }

  std::optional<Stop> witness(const Guide& guide, std::size_t k) {
    auto& answer = answerOf(k);
    const std::string base = fmt::format("trace_{}", k + 1);
    const auto formula = formulas.definitions + formulas.queries[k] + ";\n";
    if (auto problem = workspace.write(base + ".ltl", formula)) return Stop{false, *problem};
    const auto done = session.run(
        "selt", {options.tools.selt, "-q", "-p", "-S", base + ".scn", "model.ktz", base + ".ltl"});
    if (!done && done.error().isLimit) return done.error();
    std::string why = "selt gave no counterexample that can be read";
    const auto scenario = readScenario(workspace.read(base + ".scn").value_or(""));
    for (const auto& steps : {scenario.value_or(std::vector<std::string>()),
                              readCounterexample(done ? done->out : "")}) {
      if (steps.empty()) continue;
      auto followed = guide.follow(k, steps);
      if (followed) {
        answer.trace = std::move(*followed);
        if (!guide.judges(k)) answer.reason = "as far as selt reports it";
        return std::nullopt;
      }
      why = followed.error();
    }
    answer.reason = "no trace: " + why;
    return guide.judges(k) ? searched(guide, k) : std::nullopt;
  }

  /// Searches the graph itself for the violation.
  std::optional<Stop> searched(const Guide& guide, std::size_t k) {
    if (!graph) {
      if (auto done = session.run("ktzio", {options.tools.ktzio, "model.ktz", "model.txt"}); !done)
        return done.error();
      std::ifstream in(workspace.path() / "model.txt");
      auto read = readKtzText(in);
      if (!read) return Stop{false, "the text of `ktzio` is not understood: " + read.error()};
      graph = std::move(*read);
    }
    auto& answer = answerOf(k);
    auto found = guide.search(k, *graph);
    if (!found) {
      answer.reason = "no trace: " + found.error();
    } else if (*found) {
      answer = {Truth::False, std::move(**found), {}};
    } else if (answer.truth == Truth::Unknown) {
      answer = {Truth::True, std::nullopt, {}};
    } else {
      answer.reason = "no trace: no state of Tina's graph shows the violation";
    }
    return std::nullopt;
  }

  Answer& answerOf(std::size_t k) { return outcome.result.answers[order[k]]; }

  const fiacre::Program& program;
  const fiacre::Provenance& provenance;
  const std::vector<verify::Question>& questions;
  const Options& options;
  const Workspace& workspace;
  Session session;
  std::vector<std::size_t> order;      ///< indices of the questions, in the order of the formulas
  std::vector<verify::Question> asked; ///< the questions in the same order
  LtlFile formulas;
  std::optional<KtzGraph> graph;
  Outcome outcome;
};

/// The beginning and the end of a long text.
std::string shortened(const std::string& text) {
  constexpr std::size_t kMost = 4000;
  if (text.size() <= kMost) return text;
  return text.substr(0, kMost / 2) + "\n[…]\n" + text.substr(text.size() - kMost / 2);
}

} // namespace

std::expected<Outcome, Failure> verify(const fiacre::Program& program,
                                       const fiacre::Provenance& provenance,
                                       const std::vector<verify::Question>& questions,
                                       const Options& options) {
  auto workspace = Workspace::make(options.keep);
  if (!workspace) return std::unexpected(Failure{workspace.error(), {}, {}});
  return Backend(program, provenance, questions, options, *workspace).run();
}

std::string explain(const Failure& failure) {
  std::string text = failure.message;
  if (failure.calls.empty()) return text;
  const auto& last = failure.calls.back();
  text += fmt::format("\n  {}\n  {}\n", last.command, last.ended);
  if (!last.out.empty()) text += shortened(last.out) + "\n";
  if (!last.err.empty()) text += shortened(last.err) + "\n";
  return text;
}

} // namespace proskill::tina
