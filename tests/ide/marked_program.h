#pragma once

#include "ide/snapshot/snapshot.h"
#include "tests/support/marked_source.h"

#include <map>
#include <string>
#include <vector>

namespace proskill::test {

/// Marked sources, open in an editor. `^` marks the cursor in one of the files; without it, the
/// cursor is at the first `[[`.
class MarkedProgram {
public:
  /// One file, `/w/main.proskill`.
  explicit MarkedProgram(std::string_view marked)
      : MarkedProgram({{"main.proskill", std::string(marked)}}) {}
  /// By their names in the folder `/w`.
  explicit MarkedProgram(const std::map<std::string, std::string>& files);

  [[nodiscard]] const ide::Snapshot& snapshot() const { return *current; }
  /// The file with the cursor, in the first program that contains it.
  [[nodiscard]] const ide::View& view() const { return seen; }
  [[nodiscard]] syntax::Offset at() const { return cursor; }
  /// The marked ranges of a file.
  [[nodiscard]] std::vector<analysis::Location> marked() const;
  /// `name:text` of a place.
  [[nodiscard]] std::string textAt(analysis::Location place) const;

private:
  std::map<std::string, MarkedSource> sources;
  std::shared_ptr<const ide::Snapshot> current;
  ide::View seen;
  syntax::Offset cursor = 0;
};

} // namespace proskill::test
