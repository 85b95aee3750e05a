#pragma once

#include "ide/snapshot/snapshot.h"
#include "syntax/text/edit.h"

#include <string>
#include <string_view>
#include <vector>

/// What an editor offers to do at a place. Each kind of action is a file in `ide/actions/`, with
/// one function that adds what it can do there; it adds nothing where the result would not be what
/// the title says.
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
  std::shared_ptr<const AnalysedProgram> owner; ///< whose files the edits are in
  std::vector<FileEdit> edits;                  ///< of texts as they are, none over another
  const syntax::Diagnostic* fixes = nullptr;    ///< lives in the owner
  bool preferred = false;                       ///< the only way to mend it
  std::string_view explains{}; ///< a code: nothing is edited, its explanation is shown
};

struct ActionContext {
  const Snapshot& snapshot;
  std::filesystem::path path;
  View view;
  syntax::Range selection;

  [[nodiscard]] std::string_view textOf(syntax::Range range) const {
    return std::string_view(view.text()).substr(range.begin, range.length());
  }
  /// The definition that the selection stands in; null where it stands in none, or in one that was
  /// mended before it could be read.
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

/// All that can be done at a selection of a file.
[[nodiscard]] Actions actions(const Snapshot& snapshot, const std::filesystem::path& file,
                              syntax::Range selection);

/// An action on the file at hand whose result is laid out where it differs.
void addLaidOut(const ActionContext& context, Actions& actions, std::string title, ActionKind kind,
                std::vector<syntax::TextEdit> edits);

} // namespace proskill::ide
