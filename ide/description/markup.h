#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proskill::ide {

/// Words between backticks are code: the words alone, for who shows texts as they are.
[[nodiscard]] std::string withoutBackticks(std::string_view text);

/// A short text for a reader. Words between backticks in it are code.
class Markup {
public:
  /// A piece of a program.
  void code(std::string_view program);
  /// A paragraph; lines of it stay lines.
  void prose(std::string_view text);
  /// The first row is the head.
  void table(const std::vector<std::vector<std::string>>& rows);

  [[nodiscard]] bool empty() const { return inMarkdown.empty(); }
  /// CommonMark with tables, as editors show it.
  [[nodiscard]] const std::string& markdown() const { return inMarkdown; }
  /// The same for who shows texts as they are.
  [[nodiscard]] const std::string& plain() const { return inPlain; }

private:
  void add(std::string_view forMarkdown, std::string_view forPlain);

  std::string inMarkdown;
  std::string inPlain;
};

} // namespace proskill::ide
