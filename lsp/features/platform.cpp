#include "lsp/features/platform.h"

#include "lsp/protocol/convert.h"
#include "lsp/protocol/diagnostics.h"
#include "report/uri.h"
#include "runtime/check/platform_check.h"
#include "runtime/check/platform_summary.h"

#include <fmt/format.h>

#include <set>

namespace proskill::lsp {

namespace {

/// The place in the platform file, as an entry of `relatedInformation`.
Json relatedPlace(const std::filesystem::path& file, runtime::FilePlace place) {
  const Json at{{"line", place.line - 1}, {"character", place.column - 1}};
  return {{"location", {{"uri", report::toUri(file)}, {"range", {{"start", at}, {"end", at}}}}},
          {"message", "in the platform file"}};
}

Json findingJson(const runtime::PlatformFinding& finding, const ide::View& view,
                 const ide::Snapshot& snapshot, const ClientFeatures& client) {
  const Converter convert(view.program(), snapshot.open(), client.encoding);
  return diagnosticJson({view.owner, &finding.diagnostic}, convert, client,
                        finding.place ? relatedPlace(finding.file, *finding.place) : Json());
}

std::vector<runtime::PlatformFinding> findingsOf(const ide::Snapshot& snapshot,
                                                 const ide::View& view) {
  if (view.program().platforms.all.empty()) return {};
  const auto read = [&](const std::filesystem::path& path) { return snapshot.textOf(path); };
  const bool isSound = analysis::flow::hasFlow(view.program(), view.analysis());
  return runtime::checkNamedPlatform(view.program(), isSound, view.owner->settings, read);
}

} // namespace

Json platformDiagnostics(const ide::Snapshot& snapshot, const std::filesystem::path& file,
                         const ClientFeatures& client) {
  Json result = Json::array();
  if (snapshot.kindOf(file) == ide::TextKind::Notebook) return result;
  std::set<std::string> messages;
  snapshot.eachView(file, [&](const ide::View& view) {
    for (const auto& finding : findingsOf(snapshot, view))
      if (finding.diagnostic.location.file == view.file &&
          messages.insert(finding.diagnostic.message).second)
        result.push_back(findingJson(finding, view, snapshot, client));
  });
  return result;
}

namespace {

/// A place in a file as an empty range, which editors extend to a word.
Json rangeAt(std::string_view text, const syntax::LineIndex& lines, runtime::FilePlace place,
             syntax::Encoding encoding) {
  const auto at =
      syntax::fromEditor(text, lines, {place.line - 1, place.column - 1}, syntax::Encoding::Utf32);
  const auto [line, character] = syntax::toEditor(text, lines, at, encoding);
  const Json position{{"line", line}, {"character", character}};
  return {{"start", position}, {"end", position}};
}

Json inFile(const runtime::PlatformFinding& finding, std::string_view text,
            const syntax::LineIndex& lines, syntax::Encoding encoding) {
  const auto& diagnostic = finding.diagnostic;
  const bool isError = diagnostic.severity == syntax::Severity::Error;
  return {{"range", rangeAt(text, lines, finding.place.value_or(runtime::FilePlace{}), encoding)},
          {"severity",
           isError ? protocol::DiagnosticSeverity::Error : protocol::DiagnosticSeverity::Warning},
          {"code", syntax::info(diagnostic.code).id},
          {"source", "proskill"},
          {"message", finding.why}};
}

} // namespace

Json platformFileDiagnostics(const ide::Snapshot& snapshot, const std::filesystem::path& file,
                             std::string_view text, const ClientFeatures& client) {
  Json result = Json::array();
  const syntax::LineIndex lines(text);
  const auto canonical = snapshot.canonical(file);
  const auto visit = [&](const ide::View& view) {
    const auto named = analysis::namedPlatform(view.program());
    if (!named || snapshot.canonical(named->file) != canonical) return;
    for (const auto& finding : findingsOf(snapshot, view)) {
      auto shown = inFile(finding, text, lines, client.encoding);
      const bool isNew = std::ranges::find(result, shown) == result.end(); // not of another program
      if (isNew) result.push_back(std::move(shown));
    }
  };
  for (const auto& [path, open] : snapshot.open())
    if (open.kind != ide::TextKind::Notebook) snapshot.eachView(path, visit);
  return result;
}

std::optional<ide::Hover> platformHover(const ide::Snapshot& snapshot, const ide::View& view,
                                        syntax::Offset at) {
  const auto named = analysis::namedPlatform(view.program());
  if (!named || named->at.file != view.file || !named->at.range.contains(at)) return std::nullopt;
  const auto text = snapshot.textOf(named->file);
  const auto summary = text ? runtime::platformSummary(*text, view.program()) : std::nullopt;
  if (!summary) return std::nullopt;
  ide::Hover hover{{}, named->at.range};
  hover.text.prose(summary->sentence);
  for (const auto& [skill, performer] : summary->actions)
    hover.text.prose(fmt::format("`{}`: {}", skill, performer));
  return hover;
}

} // namespace proskill::lsp
