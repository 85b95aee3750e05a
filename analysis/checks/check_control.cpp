#include "analysis/checks/checks.h"

#include "analysis/names/walk.h"
#include "syntax/diagnostics/codes.h"

namespace proskill::analysis {

using syntax::Block;
using syntax::Code;
using syntax::Name;
using syntax::Statement;
using syntax::StatementKind;

namespace {

/// Checks jumps. Each parallel branch is an automaton of its own, so a jump cannot enter or leave
/// it. Within one automaton all jumps are allowed.
class Control {
public:
  Control(Context& context, const Body& body)
      : context(context), body(body), names(context, body.file) {}

  void check() {
    walk(body.block, {newBranch(), false});
    for (const Jump& jump : jumps) resolve(jump);
  }

private:
  using BranchId = std::size_t;
  struct Place {
    BranchId branch;
    bool inLoop;
  };
  struct Jump {
    Name label;
    BranchId from;
  };

  BranchId newBranch() { return branches++; }

  void walk(const Block& block, Place place) {
    for (const Statement& statement : block.statements) visit(statement, place);
  }

  void visit(const Statement& statement, Place place) {
    if (statement.kind == StatementKind::Label)
      branchOf.try_emplace(statement.name.text, place.branch);
    if (statement.kind == StatementKind::Goto && statement.name)
      jumps.push_back({statement.name, place.branch});
    if (statement.kind == StatementKind::Break && !place.inLoop)
      context.findings.report(Code::BreakOutsideLoop, {body.file, statement.range});
    const bool parallel = syntax::runsBranches(statement);
    const bool loop =
        statement.kind == StatementKind::While || statement.kind == StatementKind::DoUntil;
    for (const syntax::Arm& arm : statement.arms) walk(arm.body, place);
    for (const Block& branch : statement.branches)
      walk(branch,
           parallel ? Place{newBranch(), false} : Place{place.branch, place.inLoop || loop});
  }

  void resolve(const Jump& jump) {
    const SymbolId label = names.use(SymbolKind::Label, jump.label, Role::Mention, body.owner);
    if (label == kNoSymbol || branchOf.at(jump.label.text) == jump.from) return;
    context.findings.report(Code::JumpOutOfBranch, {body.file, jump.label.range}, jump.label.text)
        .related(context.symbols[label].at, "the label is in another branch");
  }

  Context& context;
  const Body& body;
  Names names;
  BranchId branches = 0;
  std::unordered_map<std::string_view, BranchId> branchOf; ///< by label: the branch with its first
                                                           ///< definition
  std::vector<Jump> jumps;
};

} // namespace

void checkControl(Context& context) {
  context.eachBody([&](const Body& body) { Control(context, body).check(); });
}

} // namespace proskill::analysis
