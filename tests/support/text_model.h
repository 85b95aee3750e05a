#pragma once

#include "verify/verify.h"

#include <string>

namespace proskill::test {

/// A model from text, without properties; questions are asked one by one.
class Text {
public:
  explicit Text(std::string of) : text(std::move(of)) {}

  /// The answer to `absent OBSERVABLE`, which must not depend on reductions. \pre it is decided
  [[nodiscard]] bool reaches(const std::string& observable) const {
    return isFalse("absent " + observable);
  }
  [[nodiscard]] bool isFalse(const std::string& pattern) const;
  /// The negated answer.
  [[nodiscard]] bool isTrue(const std::string& pattern) const { return !isFalse(pattern); }
  /// Number of answers from slices if they are asked first: 0 or 1.
  [[nodiscard]] std::uint64_t sliced(const std::string& pattern) const;
  /// The same of slices that are refined.
  [[nodiscard]] std::uint64_t refined(const std::string& pattern) const;
  /// The run that violates the pattern. \pre it is violated
  [[nodiscard]] verify::Trace trace(const std::string& pattern) const;
  /// The run-time error, with the text of its statement: `x := 1 / y: a division by zero`. Empty if
  /// there is none.
  [[nodiscard]] std::string error() const;
  /// Why the model cannot be explored.
  [[nodiscard]] std::string refusal() const;

private:
  std::string text;
};

/// A single process, with the type `short`.
[[nodiscard]] Text processText(const std::string& body);

} // namespace proskill::test
