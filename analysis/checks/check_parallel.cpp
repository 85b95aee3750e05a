#include "analysis/checks/checks.h"

#include "analysis/names/call_graph.h"
#include "syntax/diagnostics/codes.h"

namespace proskill::analysis {

using syntax::Statement;

namespace {

using Call = CallGraph::Call;

/// Finds calls in two branches of one `//` that may need the same skill at the same time, directly
/// or not. Two skills that start with the program are not compared.
class Parallel {
public:
  Parallel(Context& context, FileId file, const syntax::Form& form)
      : context(context), file(file), form(form) {}

  void check(const Statement& parallel) {
    Running running;
    for (const syntax::Block& branch : parallel.branches) {
      const std::vector<Call> calls = context.calls.in(branch);
      for (const Call& call : calls) compare(call, running);
      for (const Call& call : calls) addReachable(call, running);
    }
  }

private:
  /// By skill: the call that may run it.
  using Running = std::unordered_map<std::size_t, const Statement*>;

  void compare(const Call& call, const Running& running) {
    Running wanted;
    for (std::size_t skill : addReachable(call, wanted)) {
      auto other = running.find(skill);
      if (other == running.end()) continue;
      context.findings
          .report(syntax::Code::MayBeRunning, placeOf(*call.statement),
                  context.program.skills.all[skill].name())
          .related(placeOf(*other->second), "may run it at the same time");
      return;
    }
  }

  /// The new skills among the called one and those that it calls, directly or not; the nearest
  /// first.
  std::vector<std::size_t> addReachable(const Call& call, Running& reached) {
    std::vector<std::size_t> found;
    auto add = [&](std::size_t skill) {
      if (reached.try_emplace(skill, call.statement).second) found.push_back(skill);
    };
    add(call.callee);
    for (std::size_t i = 0; i < found.size(); ++i)
      for (const Call& next : context.calls.from(found[i])) add(next.callee);
    return found;
  }

  [[nodiscard]] Location placeOf(const Statement& call) const {
    return {file, call.head.range.moved(form.offset())};
  }

  Context& context;
  FileId file;
  const syntax::Form& form;
};

} // namespace

void checkParallel(Context& context) {
  const auto check = [&](const auto& definition) {
    Parallel parallel(context, definition.file, *definition.form);
    for (const Statement* each : definition.form->bodyIndexAsRead().parallels)
      parallel.check(*each);
  };
  context.each(context.program.skills, check);
  context.each(context.program.environments, check);
}

} // namespace proskill::analysis
