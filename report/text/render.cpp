#include "report/text/render.h"

#include "analysis/program/originals.h"
#include "report/text/snippet.h"
#include "report/text/source_place.h"
#include "report/text/text_width.h"
#include "syntax/text/utf8.h"

#include <algorithm>
#include <iostream>
#include <map>

namespace proskill::report {

using syntax::Diagnostic;
using syntax::FileId;
using syntax::Severity;

namespace {

Colour colourOf(Severity severity) {
  switch (severity) {
  case Severity::Error: return Colour::Red;
  case Severity::Warning: return Colour::Yellow;
  case Severity::Hint: return Colour::Cyan;
  }
  return Colour::Bold;
}

/// The marks of a diagnostic by file; its own file is first.
std::vector<std::pair<FileId, std::vector<Mark>>> marksByFile(const Diagnostic& diagnostic) {
  std::vector<std::pair<FileId, std::vector<Mark>>> files{
      {diagnostic.location.file, {{diagnostic.location.range, "", true}}}};
  for (const syntax::Related& related : diagnostic.related) {
    auto file = std::ranges::find(files, related.location.file,
                                  &std::pair<FileId, std::vector<Mark>>::first);
    if (file == files.end()) file = files.insert(files.end(), {related.location.file, {}});
    file->second.push_back({related.location.range, related.message, false});
  }
  return files;
}

class Renderer {
public:
  Renderer(std::ostream& out, const analysis::Program& program, const Paint& paint)
      : out(out), program(program), paint(paint), places(program), originals(program) {}

  void print(const Diagnostic& diagnostic) {
    const Colour colour = colourOf(diagnostic.severity);
    const auto& code = syntax::info(diagnostic.code).id;
    const auto head = std::string(words(diagnostic.severity)) + "[" + std::string(code) + "]";
    out << paint(colour, head)
        << paint(Colour::Bold, ": " + DisplayedLine(diagnostic.message).text()) << '\n';
    const auto files = marksByFile(diagnostic);
    std::vector<Snippet> snippets;
    std::size_t gutter = 1;
    for (const auto& [file, marks] : files) {
      snippets.emplace_back(program.files[file].document, marks);
      gutter = std::max(gutter, snippets.back().gutterWidth());
    }
    const std::string margin(gutter, ' ');
    for (std::size_t i = 0; i < files.size(); ++i) {
      const auto& [file, marks] = files[i];
      const SourcePlace at = places.at(file, marks.front().range.begin);
      out << margin << paint(Colour::Blue, i == 0 ? "--> " : "::: ")
          << syntax::printable(places.path(file)) << ':' << at.line << ':' << at.column << '\n';
      snippets[i].print(out, gutter, paint, colour);
    }
    const auto original = originals.of(diagnostic.location);
    if (original || !diagnostic.fixes.empty()) out << paint(Colour::Blue, margin + " |") << '\n';
    if (original)
      out << margin << paint(Colour::Blue, " = ") << paint(Colour::Bold, "from") << ": "
          << DisplayedLine(toString(*original)).text() << '\n';
    for (const syntax::Fix& fix : diagnostic.fixes)
      out << margin << paint(Colour::Blue, " = ") << paint(Colour::Bold, "help") << ": "
          << DisplayedLine(fix.title).text() << '\n';
    out << '\n';
  }

private:
  std::ostream& out;
  const analysis::Program& program;
  const Paint& paint;
  SourcePlaces places;
  analysis::ProgramOriginals originals;
};

} // namespace

std::string_view words(Severity severity) {
  switch (severity) {
  case Severity::Error: return "error";
  case Severity::Warning: return "warning";
  case Severity::Hint: return "hint";
  }
  return {};
}

void render(std::ostream& out, const analysis::Program& program,
            std::span<const Diagnostic> diagnostics, const Paint& paint) {
  Renderer renderer(out, program, paint);
  for (const Diagnostic& diagnostic : diagnostics) renderer.print(diagnostic);
}

} // namespace proskill::report
