#pragma once

#include "syntax/tree/form.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace proskill::syntax {

/// The numbers that a program's constants stand for, by name.
using ConstantValues = std::unordered_map<std::string_view, const Expr*>;

/// Puts the numbers of a program's constants into its forms. The numbers keep the constants' names
/// and ranges. A wait for a constant alone becomes a wait for that time. Each form remembers its
/// result for the next program with the same constants.
class ConstantFiller {
public:
  /// \pre `values` outlive the filler
  explicit ConstantFiller(const ConstantValues& values);

  /// \param text the text of the form, which outlives the result
  /// \return nullopt: the form mentions no constant
  [[nodiscard]] std::optional<Form> filled(const Form& form, std::string_view text) const;

private:
  [[nodiscard]] bool mentionsAny(std::string_view text) const;

  const ConstantValues& values;
  std::shared_ptr<const std::string> key;
};

} // namespace proskill::syntax
