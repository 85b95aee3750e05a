#pragma once

#include "ide/snapshot/snapshot.h"
#include "syntax/text/edit.h"

#include <string>
#include <string_view>
#include <vector>

/// Code actions: edits that an editor offers at a place. Each kind of action is a file in
/// `ide/actions/` with one function that adds its actions. An action is added only if its result is
/// what its title says.
namespace proskill::ide {

enum class ActionKind : std::uint8_t {
  QuickFix,
  RefactorExtract,
  RefactorInline,
  RefactorRewrite,
  SourceFixAll,
  SourceOrganizeFields,
};

struct FileEdit {
  analysis::FileId file = 0;
  syntax::TextEdit edit;
};

struct Action {
  std::string title;
  ActionKind kind = ActionKind::QuickFix;
  std::shared_ptr<const AnalysedProgram> owner; ///< the program whose files the edits change
  std::vector<FileEdit> edits;                  ///< of the current texts, without overlaps
  const syntax::Diagnostic* fixes = nullptr;    ///< owned by `owner`
  bool preferred = false;                       ///< the only fix for the diagnostic
  std::string_view explains{}; ///< a code: the action edits nothing and shows its explanation
};

struct ActionContext {
  const Snapshot& snapshot;
  std::filesystem::path path;
  View view;
  syntax::Range selection;

  [[nodiscard]] std::string_view textOf(syntax::Range range) const {
    return std::string_view(view.text()).substr(range.begin, range.length());
  }
  /// The definition that contains the selection; null if there is none, or if it was repaired
  /// before parsing.
  [[nodiscard]] const syntax::Form* form() const;
};

using Actions = std::vector<Action>;

void addDiagnosticFixes(const ActionContext& context, Actions& actions);
void addIgnore(const ActionContext& context, Actions& actions);
void addExplain(const ActionContext& context, Actions& actions);
void addFixAll(const ActionContext& context, Actions& actions);
void addFailureBranch(const ActionContext& context, Actions& actions);
void addWrapInIf(const ActionContext& context, Actions& actions);
void addExtractSkill(const ActionContext& context, Actions& actions);
void addInlineSkill(const ActionContext& context, Actions& actions);
void addMonitor(const ActionContext& context, Actions& actions);
void addTransitions(const ActionContext& context, Actions& actions);
void addSortFields(const ActionContext& context, Actions& actions);

/// All actions for a selection in a file.
[[nodiscard]] Actions actions(const Snapshot& snapshot, const std::filesystem::path& file,
                              syntax::Range selection);

/// Adds an action on the current file; the changed text is formatted.
void addLaidOut(const ActionContext& context, Actions& actions, std::string title, ActionKind kind,
                std::vector<syntax::TextEdit> edits);

} // namespace proskill::ide
