#include "analysis/flow/ignores.h"

#include "analysis/names/findings.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <string_view>

namespace proskill::analysis::flow {

namespace {

using syntax::Code;
using syntax::Diagnostic;

constexpr std::string_view kMark = "proskill-ignore:";
constexpr std::string_view kBetween = " \t,";
/// From this code on, findings are about the file of the platform, which is not read here.
constexpr std::string_view kPlatforms = "PS1400";

/// One code in one comment.
struct Ignore {
  Location at;           ///< of the code
  syntax::Range comment; ///< with its line, if it is alone there
  bool isOnly = true;    ///< in the comment
  std::string_view word;
  const syntax::CodeInfo* code = nullptr;
  std::uint32_t line = 0; ///< to which it applies
  bool used = false;
};

class Ignores {
public:
  explicit Ignores(const Program& program) : program(program) {
    for (FileId file = 0; file < program.files.size(); ++file) read(file);
  }

  bool covers(const Diagnostic& diagnostic) {
    if (all.empty() || isFatal(diagnostic)) return false;
    std::uint32_t line = lineOf(diagnostic.location);
    bool covered = false;
    for (Ignore& each : all) {
      if (!each.code || each.code->code != diagnostic.code) continue;
      if (each.at.file != diagnostic.location.file || each.line != line) continue;
      each.used = covered = true;
    }
    return covered;
  }

  void reportUnused(Findings& findings) const {
    for (const Ignore& each : all) {
      if (!each.code)
        findings.report(Code::IgnoresUnknownCode, each.at, each.word);
      else if (!each.used && each.code->id < kPlatforms)
        findings.report(Code::IgnoresNothing, each.at, each.word)
            .fix(each.isOnly ? "remove the comment" : "remove the code",
                 {each.at.file, each.isOnly ? each.comment : each.at.range}, "");
    }
  }

private:
  static bool isFatal(const Diagnostic& diagnostic) {
    const auto id = syntax::info(diagnostic.code).id;
    return diagnostic.severity == syntax::Severity::Error && (id < "PS0500" || id >= kPlatforms);
  }

  [[nodiscard]] std::uint32_t lineOf(Location at) const {
    return program.files[at.file].document.lines().position(at.range.begin).line;
  }

  /// Several of these comments may follow each other; all apply to the line after the last.
  void read(FileId file) {
    const syntax::Document& document = program.files[file].document;
    const std::string_view text = document.text();
    std::size_t open = all.size();
    for (const syntax::Range& comment : document.comments()) {
      std::string_view words = text.substr(comment.begin, comment.length());
      std::size_t mark = words.find(kMark);
      if (mark == std::string_view::npos) continue;
      std::uint32_t line = lineOf({file, comment});
      if (open < all.size() && all.back().line != line) open = all.size();
      std::size_t first = all.size();
      addCodes(file, comment.begin, words, mark + kMark.size());
      for (std::size_t i = first; i < all.size(); ++i) {
        all[i].comment = withLine(text, comment);
        all[i].isOnly = all.size() == first + 1;
      }
      for (std::size_t i = open; i < all.size(); ++i) all[i].line = line + 1;
    }
  }

  static syntax::Range withLine(std::string_view text, syntax::Range comment) {
    auto [begin, end] = comment;
    while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t')) --begin;
    if (begin > 0 && text[begin - 1] != '\n') return {begin, end};
    if (end < text.size() && text[end] == '\r') ++end;
    if (end < text.size() && text[end] == '\n') ++end;
    return {begin, end};
  }

  void addCodes(FileId file, syntax::Offset base, std::string_view words, std::size_t from) {
    while ((from = words.find_first_not_of(kBetween, from)) != std::string_view::npos) {
      std::size_t end = std::min(words.find_first_of(kBetween, from), words.size());
      std::string_view word = words.substr(from, end - from);
      auto begin = static_cast<syntax::Offset>(base + from);
      auto stop = static_cast<syntax::Offset>(base + end);
      all.push_back({.at = {file, {begin, stop}}, .word = word, .code = syntax::findCode(word)});
      from = end;
    }
  }

  const Program& program;
  std::vector<Ignore> all;
};

} // namespace

std::vector<Diagnostic> withoutIgnored(const Program& program,
                                       std::vector<Diagnostic> diagnostics) {
  Ignores ignores(program);
  std::erase_if(diagnostics, [&](const Diagnostic& each) { return ignores.covers(each); });
  Findings findings(std::move(diagnostics));
  ignores.reportUnused(findings);
  return std::move(findings).inOrder();
}

} // namespace proskill::analysis::flow
