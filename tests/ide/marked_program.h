#pragma once

#include "ide/snapshot/snapshot.h"
#include "tests/support/marked_source.h"

#include <map>
#include <string>
#include <vector>

namespace proskill::test {

/// Marked sources, open in an editor: what a feature is asked about. `^` is where the cursor
/// stands, in one of the files; where there is none, it stands at the begin of the first `[[`.
class MarkedProgram {
public:
  /// One file, `/w/main.proskill`.
  explicit MarkedProgram(std::string_view marked)
      : MarkedProgram({{"main.proskill", std::string(marked)}}) {}
  /// By their names in the folder `/w`.
  explicit MarkedProgram(const std::map<std::string, std::string>& files);

  [[nodiscard]] const ide::Snapshot& snapshot() const { return *current; }
  /// The file that the cursor stands in, within the first program that it belongs to.
  [[nodiscard]] const ide::View& view() const { return seen; }
  [[nodiscard]] syntax::Offset at() const { return cursor; }
  /// The ranges that are marked in a file, as a test compares them.
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
