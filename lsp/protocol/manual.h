#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace proskill::lsp {

/// The page of the manual that explains the codes of diagnostics, as `proskill explain --markdown`
/// writes it.
class Manual {
public:
  /// If the page cannot be read, there are no links.
  explicit Manual(const std::filesystem::path& page);

  /// The URI of the page with the line of the code, `file:///…/diagnostics.md#L12`; empty if the
  /// page does not explain this code.
  [[nodiscard]] std::string linkTo(std::string_view code) const;

private:
  std::string uri;
  std::map<std::string, unsigned, std::less<>> lines; ///< of the headings, counted from 1
};

} // namespace proskill::lsp
