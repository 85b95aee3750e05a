#pragma once

#include <string>
#include <vector>

namespace proskill::bridge {

/// A word, or a list in parentheses; a comment is above it.
struct Form {
  std::string word; ///< of a list: empty
  std::vector<Form> parts;
  std::string comment;

  Form(const char* text) : word(text) {}
  Form(std::string text) : word(std::move(text)) {}
  explicit Form(std::vector<Form> list) : parts(std::move(list)) {}

  /// Without regard to comments.
  friend bool operator==(const Form& a, const Form& b) {
    return a.word == b.word && a.parts == b.parts;
  }
};

/// Statements, or the definitions of a program.
using Block = std::vector<Form>;

template <class... Parts> Form list(Parts&&... parts) {
  return Form(std::vector<Form>{Form(std::forward<Parts>(parts))...});
}

/// Whether `part` is the form or somewhere in it.
[[nodiscard]] bool contains(const Form& form, const Form& part);

void append(Block& block, const Block& more);

/// The text of a program, formatted as `proskill fmt` does.
[[nodiscard]] std::string write(const std::string& head, const Block& program);

} // namespace proskill::bridge
