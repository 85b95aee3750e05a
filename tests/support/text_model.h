#pragma once

#include "verify/verify.h"

#include <string>

namespace proskill::test {

/// A model by its text, without properties; they are asked one by one.
class Text {
public:
  explicit Text(std::string of) : text(std::move(of)) {}

  /// The answer to `absent OBSERVABLE`, the same whatever is reduced. \pre it is decided
  [[nodiscard]] bool reaches(const std::string& observable) const {
    return isFalse("absent " + observable);
  }
  [[nodiscard]] bool isFalse(const std::string& pattern) const;
  /// The same, the other way round.
  [[nodiscard]] bool isTrue(const std::string& pattern) const { return !isFalse(pattern); }
  /// How many answers slices give if they are asked first: 0 or 1.
  [[nodiscard]] std::uint64_t sliced(const std::string& pattern) const;
  /// The run that makes the pattern false. \pre it is
  [[nodiscard]] verify::Trace trace(const std::string& pattern) const;
  /// What goes wrong at run time, and the text of the statement that it does in: `x := 1 / y: a
  /// division by zero`. Empty where nothing does.
  [[nodiscard]] std::string error() const;
  /// Why the model cannot be explored at all.
  [[nodiscard]] std::string refusal() const;

private:
  std::string text;
};

/// One process, alone, with the type `short`.
[[nodiscard]] Text processText(const std::string& body);

} // namespace proskill::test
