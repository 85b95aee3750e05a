#pragma once

#include "analysis/flow/domain/variables.h"

#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace proskill::analysis::flow {

/// The values that the inputs of skills can have: those that calls pass, directly or as an input of
/// the caller; of a library's skills, any. Truth values are numbers: 0 is false, 1 is true. Inputs
/// of other types than these and state variables are unknown.
class Inputs {
public:
  struct Input {
    std::optional<VariableId> type; ///< the state variable whose values it has; none: a truth value
    std::vector<Span> values{};     ///< of any call
  };

  Inputs(const Program& program, const Variables& variables);

  /// \param name with its `$`
  /// \return null if it is unknown
  [[nodiscard]] const Input* find(std::size_t skill, std::string_view name) const;

private:
  using Key = std::pair<std::size_t, std::string_view>;

  void declare(std::size_t skill);
  void pass(std::size_t caller, const syntax::Statement& call);
  void passValue(const Key& from, const syntax::Expr& value, const Key& to);
  [[nodiscard]] std::optional<std::int64_t> numberOf(const syntax::Expr& value,
                                                     const Input& input) const;
  void spread();
  [[nodiscard]] Span allValues(const Input& input) const;
  void setValues(Input& input, const std::set<std::int64_t>& given) const;

  const Program& program;
  const Variables& variables;
  std::map<Key, Input> known;
  std::map<Key, std::set<std::int64_t>> numbers;
  std::set<Key> any;                       ///< they may have every value
  std::vector<std::pair<Key, Key>> passed; ///< from the caller's to the callee's
};

} // namespace proskill::analysis::flow
