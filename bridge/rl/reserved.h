#pragma once

#include "analysis/program/program.h"

#include <map>
#include <set>
#include <string>

namespace proskill::bridge::rl {

/// Names of a program as RL can read them: a word that RL reserves gets a `_` at its end, or as
/// many as make it a new name.
class Names {
public:
  explicit Names(const analysis::Program& program);

  /// \pre the name is one of the program, unless it is not reserved
  [[nodiscard]] std::string operator()(std::string_view name) const;
  /// The new names, by the old ones.
  [[nodiscard]] const std::map<std::string, std::string, std::less<>>& renamed() const {
    return changed;
  }

private:
  std::map<std::string, std::string, std::less<>> changed;
};

} // namespace proskill::bridge::rl
