#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proskill::ide {

/// The text without the backticks around code, for clients that show plain text.
[[nodiscard]] std::string withoutBackticks(std::string_view text);

/// A short text for users. Words between backticks are code.
class Markup {
public:
  /// Appends a block of code.
  void code(std::string_view program);
  /// Appends a paragraph; line breaks are kept.
  void prose(std::string_view text);
  /// Appends a table; the first row is its head.
  void table(const std::vector<std::vector<std::string>>& rows);

  [[nodiscard]] bool empty() const { return inMarkdown.empty(); }
  /// CommonMark with tables, as editors show it.
  [[nodiscard]] const std::string& markdown() const { return inMarkdown; }
  /// The same as plain text.
  [[nodiscard]] const std::string& plain() const { return inPlain; }

private:
  void add(std::string_view forMarkdown, std::string_view forPlain);

  std::string inMarkdown;
  std::string inPlain;
};

} // namespace proskill::ide
