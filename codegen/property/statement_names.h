#pragma once

#include "codegen/plan/body_automaton.h"

#include <map>
#include <string>

namespace proskill::codegen {

/// The names of a body's statements in the names of checks: `call[takeoff]`, and `call[takeoff].2`
/// for the second one in the order of the text. They contain no line numbers, so that edits
/// elsewhere do not change them.
class StatementNames {
public:
  /// The statements of the body and its branches. This object refers to `body`.
  explicit StatementNames(const BodyAutomaton& body);

  /// \pre the statement has a state in the body
  [[nodiscard]] const std::string& of(const syntax::Statement& statement) const {
    return names.at(&statement);
  }

private:
  std::map<const syntax::Statement*, std::string> names;
};

} // namespace proskill::codegen
