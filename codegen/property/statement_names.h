#pragma once

#include "codegen/plan/body_automaton.h"

#include <map>
#include <string>

namespace proskill::codegen {

/// What the statements of a body are called in the names of questions: `call[takeoff]`, the second
/// one in the order of the text `call[takeoff].2`. They hold no lines, so that an edit elsewhere
/// leaves them as they are.
class StatementNames {
public:
  /// Of the body and its branches; it looks into them.
  explicit StatementNames(const BodyAutomaton& body);

  /// \pre the statement has a state in the body
  [[nodiscard]] const std::string& of(const syntax::Statement& statement) const {
    return names.at(&statement);
  }

private:
  std::map<const syntax::Statement*, std::string> names;
};

} // namespace proskill::codegen
