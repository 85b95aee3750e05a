#pragma once

#include <functional>
#include <string>
#include <vector>

namespace proskill::test {

/// A word, or a parenthesised list: programs as trees that tests can reduce.
struct Form {
  std::string word; ///< empty: a list
  std::vector<Form> items;

  Form() = default;
  Form(std::string text) : word(std::move(text)) {}
  Form(const char* text) : word(text) {}
  Form(std::initializer_list<Form> parts) : items(parts) {}

  [[nodiscard]] bool isList() const { return word.empty(); }
  void add(Form item) { items.push_back(std::move(item)); }
  void addAll(const std::vector<Form>& more) {
    items.insert(items.end(), more.begin(), more.end());
  }
  friend bool operator==(const Form&, const Form&) = default;
};

/// The text of a program, formatted for readers.
[[nodiscard]] std::string textOf(const std::vector<Form>& program);

/// Removes forms, fields, statements and branches, and replaces them by their parts, while `shows`
/// stays true. \pre shows(program) Zeller and Hildebrandt, "Simplifying and isolating
/// failure-inducing input" (TSE 2002), greedy, on the tree.
[[nodiscard]] std::vector<Form>
minimise(std::vector<Form> program, const std::function<bool(const std::vector<Form>&)>& shows);

} // namespace proskill::test
