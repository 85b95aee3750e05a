#include "codegen/plan/origins.h"

#include "syntax/text/utf8.h"

#include <fmt/format.h>

namespace proskill::codegen {

fiacre::OriginId Origins::of(const Actor& actor, syntax::Range range, std::string_view words) {
  const auto next = static_cast<fiacre::OriginId>(provenance.origins.size());
  const auto [place, isNew] =
      known.emplace(Key{actor.file, range.begin, range.end, actor.name, std::string(words)}, next);
  if (isNew)
    provenance.origins.push_back(
        {actor.file, range.begin, range.end, actor.name, std::string(words)});
  return place->second;
}

std::string Origins::excerpt(syntax::FileId file, syntax::Range range) const {
  constexpr std::size_t kLongest = 70;
  const std::string_view text =
      std::string_view(program.files[file].document.text()).substr(range.begin, range.length());
  std::string line;
  bool inComment = false;
  bool inString = false;
  for (const char c : text) {
    if (c == '"' && !inComment && !line.ends_with('\\')) inString = !inString;
    if (c == ';' && !inString) inComment = true;
    if (c == '\n') inComment = false;
    const bool blank = inComment || c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!blank)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  if (line.size() <= kLongest) return line;
  // cut between UTF-8 characters
  return line.substr(0, syntax::characterStart(line, kLongest)) + "...";
}

syntax::Position Origins::position(syntax::FileId file, syntax::Range range) const {
  const auto position = program.files[file].document.lines().position(range.begin);
  return {position.line + 1, position.column + 1};
}

std::string Origins::line(syntax::FileId file, syntax::Range range) const {
  const auto number = position(file, range).line;
  if (file == 0) return fmt::format("line {}", number);
  return fmt::format("{}, line {}", program.files[file].path.filename().string(), number);
}

std::string Origins::definition(syntax::FileId file, const syntax::Form& form,
                                std::string_view name) const {
  return fmt::format("{}: {} {}", line(file, form.range), form.keyword.text, name);
}

std::string Origins::reference(syntax::FileId file, syntax::Range range) const {
  return fmt::format("{}: {}", line(file, range), excerpt(file, range));
}

} // namespace proskill::codegen
