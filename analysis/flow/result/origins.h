#pragma once

#include "analysis/flow/result/report.h"

#include <string>
#include <unordered_set>
#include <vector>

namespace proskill::analysis::flow {

/// A possible origin of a value: an effect, or the start of the program.
struct Origin {
  Location at;
  std::string description; ///< "becomes Good here"
};

/// The effects of a program, by variable.
class Origins {
public:
  explicit Origins(const Report& report);

  /// The first few places at which the variable gets a value of the set.
  [[nodiscard]] std::vector<Origin> of(VariableId variable, ValueSet values) const;

private:
  struct Write {
    Location at;
    ValueSet to;
  };
  void add(FileId file, const Action& action);

  const Report& report;
  std::vector<std::vector<Write>> writes; ///< by variable
  std::unordered_set<const syntax::Effect*> seen;
};

} // namespace proskill::analysis::flow
