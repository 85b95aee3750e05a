#include "analysis/checks.h"

#include "analysis/call_graph.h"
#include "analysis/walk.h"
#include "syntax/codes.h"

namespace proskill::analysis {

using syntax::Statement;
using syntax::StatementKind;

namespace {

using Call = CallGraph::Call;

/// Calls in two branches of one `//` that may want the same skill at the same time: itself, or
/// through what they call. Two skills that start with the program are not compared.
class Parallel {
public:
  explicit Parallel(Context& context) : context(context), graph(context.program) {}

  void check(const Statement& parallel, FileId file) {
    Running running;
    for (const syntax::Block& branch : parallel.branches) {
      const std::vector<Call> calls = graph.in(branch);
      for (const Call& call : calls) compare(call, running, file);
      for (const Call& call : calls) addReachable(call, running);
    }
  }

private:
  /// Of each skill the call that may run it.
  using Running = std::unordered_map<std::size_t, const Statement*>;

  void compare(const Call& call, const Running& running, FileId file) {
    Running wanted;
    for (std::size_t skill : addReachable(call, wanted)) {
      auto other = running.find(skill);
      if (other == running.end()) continue;
      context.findings
          .report(syntax::Code::MayBeRunning, {file, call.statement->head.range},
                  context.program.skills.all[skill].name())
          .related({file, other->second->head.range}, "may run it at the same time");
      return;
    }
  }

  /// The skill that is called and those that it calls, the nearest first, as far as they are new.
  std::vector<std::size_t> addReachable(const Call& call, Running& reached) {
    std::vector<std::size_t> found;
    auto add = [&](std::size_t skill) {
      if (reached.try_emplace(skill, call.statement).second) found.push_back(skill);
    };
    add(call.callee);
    for (std::size_t i = 0; i < found.size(); ++i)
      for (const Call& next : graph.from(found[i])) add(next.callee);
    return found;
  }

  Context& context;
  CallGraph graph;
};

} // namespace

void checkParallel(Context& context) {
  Parallel parallel(context);
  context.eachBody([&](const Body& body) {
    forEachStatement(body.block, [&](const Statement& statement) {
      if (statement.kind == StatementKind::Parallel) parallel.check(statement, body.file);
    });
  });
}

} // namespace proskill::analysis
