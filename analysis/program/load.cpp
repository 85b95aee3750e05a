#include "analysis/program/constants.h"
#include "analysis/program/program.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace proskill::analysis {

namespace {

namespace fs = std::filesystem;

/// Builds a program file by file. Includes are followed at their places, so that definitions are in
/// the order in which a reader meets them.
class Loader {
public:
  Loader(const FileSystem& files, Program& program) : files(files), program(program) {}

  void add(const fs::path& path, const fs::path& canonical, syntax::Document document) {
    const auto id = static_cast<FileId>(program.files.size());
    loaded.insert(canonical);
    open.push_back({canonical, path, {}});
    program.files.push_back({files.nameOf(path), document, canonical.native()});
    for (syntax::Diagnostic diagnostic : document.diagnostics())
      program.diagnostics.push_back(inFile(std::move(diagnostic), id));
    for (const syntax::Form& form : document.forms()) define(form, id);
    open.pop_back();
  }

private:
  /// A file whose includes are being followed, with the position of the current one.
  struct OpenFile {
    fs::path canonical;
    fs::path path; ///< the path through which it was reached, relative to which its includes are
                   ///< found
    Location include;
  };

  static syntax::Diagnostic inFile(syntax::Diagnostic diagnostic, FileId id) {
    diagnostic.location.file = id;
    for (syntax::Related& related : diagnostic.related) related.location.file = id;
    for (syntax::Fix& fix : diagnostic.fixes) fix.location.file = id;
    return diagnostic;
  }

  void define(const syntax::Form& form, FileId id) {
    if (const auto* include = form.as<syntax::Include>(); include && include->path)
      follow(include->path, id);
    std::apply([&](auto&... tables) { (enter(tables, form, id), ...); },
               std::tie(program.constants, program.stateVariables, program.events, program.skills,
                        program.resources, program.properties, program.environments,
                        program.platforms));
  }

  template <class Node> static void enter(Table<Node>& table, const syntax::Form& form, FileId id) {
    if (!form.is<Node>()) return;
    if (form.name) table.byName.try_emplace(form.name.text, table.all.size());
    table.all.push_back({&form, id});
  }

  void follow(const syntax::Name& written, FileId from) {
    const Location at{from, written.range};
    open.back().include = at;
    const fs::path path =
        (open.back().path.parent_path() / fs::path(written.text)).lexically_normal();
    const fs::path canonical = files.canonical(path);
    if (isOpen(canonical)) return cycle(canonical, at);
    if (loaded.contains(canonical)) return;
    if (open.size() > kDeepestInclude) return unreadable(written, at, "includes go too deep");
    auto document = files.document(path);
    if (!document) return unreadable(written, at, document.error());
    add(path, canonical, std::move(*document));
  }

  [[nodiscard]] bool isOpen(const fs::path& canonical) const {
    return std::ranges::find(open, canonical, &OpenFile::canonical) != open.end();
  }

  void unreadable(const syntax::Name& written, Location at, std::string_view why) {
    program.diagnostics.push_back(
        syntax::makeDiagnostic(syntax::Code::UnreadableFile, at, written.text, why));
  }

  void cycle(const fs::path& canonical, Location at) {
    auto diagnostic = syntax::makeDiagnostic(syntax::Code::IncludeCycle, at,
                                             canonical.filename().generic_string());
    auto first = std::ranges::find(open, canonical, &OpenFile::canonical);
    for (auto it = first; it + 1 != open.end(); ++it)
      diagnostic.related.push_back(
          {it->include, "`" + it->path.filename().generic_string() + "` includes `" +
                            (it + 1)->path.filename().generic_string() + "` here"});
    program.diagnostics.push_back(std::move(diagnostic));
  }

  /// Deeper chains are generated, or endless because of links.
  static constexpr std::size_t kDeepestInclude = 200;

  const FileSystem& files;
  Program& program;
  std::set<fs::path> loaded;
  std::vector<OpenFile> open;
};

} // namespace

Program load(const FileSystem& files, const fs::path& root, Extent extent) {
  auto document = files.document(root);
  if (document) return load(files, root, std::move(*document), extent);
  Program program = load(files, root, syntax::Document::parse(""), extent);
  program.diagnostics.push_back(syntax::makeDiagnostic(syntax::Code::UnreadableFile, {},
                                                       root.generic_string(), document.error()));
  return program;
}

Program load(const FileSystem& files, const fs::path& root, syntax::Document document,
             Extent extent) {
  Program program;
  program.extent = extent;
  Loader(files, program).add(root, files.canonical(root), std::move(document));
  fillInConstants(program);
  return program;
}

} // namespace proskill::analysis
