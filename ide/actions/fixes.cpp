#include "ide/actions/action.h"
#include "ide/description/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace proskill::ide {

namespace {

using syntax::Diagnostic;

std::vector<Finding> findingsAt(const ActionContext& context) {
  auto findings = diagnostics(context.snapshot, context.path);
  std::erase_if(findings, [&](const Finding& finding) {
    return !finding.diagnostic->location.range.touches(context.selection);
  });
  return findings;
}

FileEdit editOf(const syntax::Fix& fix) {
  return {fix.location.file, {fix.location.range, fix.text}};
}

/// Whether the fix can be applied without review: it is the only one, and keeps the meaning of the
/// program.
bool isSafe(const Diagnostic& diagnostic) {
  return diagnostic.fixes.size() == 1 && !syntax::info(diagnostic.code).id.starts_with("PS05");
}

/// All edits, except those that overlap an earlier one.
std::vector<FileEdit> merged(const std::vector<const Diagnostic*>& found) {
  std::vector<FileEdit> edits;
  for (const auto* diagnostic : found) {
    auto edit = editOf(diagnostic->fixes.front());
    bool clashes = std::ranges::any_of(edits, [&](const FileEdit& other) {
      return other.file == edit.file && other.edit.range.touches(edit.edit.range);
    });
    if (!clashes) edits.push_back(std::move(edit));
  }
  std::ranges::sort(
      edits, {}, [](const FileEdit& edit) { return std::pair(edit.file, edit.edit.range.begin); });
  return edits;
}

/// The findings of a file that can be fixed safely, in the first program that contains the file.
std::vector<const Diagnostic*> fixable(const ActionContext& context) {
  std::vector<const Diagnostic*> result;
  for (const auto& finding : diagnostics(context.snapshot, context.path))
    if (finding.owner == context.view.owner && isSafe(*finding.diagnostic))
      result.push_back(finding.diagnostic);
  return result;
}

/// Errors of form, names and types cannot be ignored, since the program has no meaning with them.
bool canBeIgnored(const Diagnostic& diagnostic) {
  return diagnostic.severity != syntax::Severity::Error ||
         syntax::info(diagnostic.code).id >= "PS0500";
}

} // namespace

void addDiagnosticFixes(const ActionContext& context, Actions& actions) {
  for (const auto& finding : findingsAt(context))
    for (const auto& fix : finding.diagnostic->fixes)
      actions.push_back({fix.title,
                         ActionKind::QuickFix,
                         finding.owner,
                         {editOf(fix)},
                         finding.diagnostic,
                         finding.diagnostic->fixes.size() == 1});
}

void addIgnore(const ActionContext& context, Actions& actions) {
  for (const auto& finding : findingsAt(context)) {
    const auto& diagnostic = *finding.diagnostic;
    auto id = syntax::info(diagnostic.code).id;
    if (!canBeIgnored(diagnostic) || id.starts_with("PS12")) continue;
    const auto& document = finding.owner->program.files[diagnostic.location.file].document;
    auto at = diagnostic.location.range.begin;
    auto line = document.lines().line(document.lines().position(at).line, document.text());
    auto words = std::string_view(document.text()).substr(line.begin, line.length());
    auto indent = words.substr(0, words.find_first_not_of(" \t"));
    actions.push_back(
        {fmt::format("Ignore {} here", id),
         ActionKind::QuickFix,
         finding.owner,
         {{diagnostic.location.file,
           {{line.begin, line.begin}, fmt::format("{}; proskill-ignore: {}\n", indent, id)}}},
         &diagnostic});
  }
}

/// Adds one explanation for each code, after all fixes.
void addExplain(const ActionContext& context, Actions& actions) {
  std::set<syntax::Code> explained;
  for (const auto& finding : findingsAt(context)) {
    if (!explained.insert(finding.diagnostic->code).second) continue;
    auto id = syntax::info(finding.diagnostic->code).id;
    actions.push_back({.title = fmt::format("Explain {}", id),
                       .owner = finding.owner,
                       .fixes = finding.diagnostic,
                       .explains = id});
  }
}

void addFixAll(const ActionContext& context, Actions& actions) {
  auto all = fixable(context);
  if (all.empty()) return;
  std::map<syntax::Code, std::vector<const Diagnostic*>> byCode;
  for (const auto* diagnostic : all) byCode[diagnostic->code].push_back(diagnostic);
  for (const auto& finding : findingsAt(context)) {
    auto same = byCode.find(finding.diagnostic->code);
    if (same == byCode.end() || same->second.size() < 2) continue;
    actions.push_back({fmt::format("Fix all {} in this file", syntax::info(same->first).id),
                       ActionKind::QuickFix, context.view.owner, merged(same->second),
                       finding.diagnostic});
    byCode.erase(same);
  }
  actions.push_back(
      {"Apply all automatic fixes", ActionKind::SourceFixAll, context.view.owner, merged(all)});
}

} // namespace proskill::ide
