#pragma once

#include "analysis/program/program.h"

#include <map>
#include <optional>

namespace proskill::analysis {

/// The place of another language that a part of an imported program comes from.
struct Original {
  std::filesystem::path file; ///< in a comment: relative to the program's own file
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  std::string what; ///< what is there, such as `skill goto`
};

/// The originals of one text. `proskill import` writes a comment above each part that it
/// translates, `; from FILE:LINE:COLUMN WHAT`; it is about the list in parentheses that follows.
class Originals {
public:
  explicit Originals(std::string_view text);

  /// That of the innermost list with such a comment that contains the offset, or null.
  [[nodiscard]] const Original* at(syntax::Offset offset) const;

private:
  struct Part {
    syntax::Range range;
    std::size_t parent;
    Original original;
  };
  std::vector<Part> parts; ///< in the order of their beginnings
};

/// The same for all files of a program; each is read when it is first asked for.
class ProgramOriginals {
public:
  explicit ProgramOriginals(const Program& program) : program(program) {}

  /// The original of a place. Its file is seen from where the program's own file is seen.
  [[nodiscard]] std::optional<Original> of(Location location);

private:
  const Program& program;
  std::map<FileId, Originals> known;
};

/// `FILE:LINE:COLUMN WHAT`, as it is written in comments.
[[nodiscard]] std::string toString(const Original& original);

} // namespace proskill::analysis
