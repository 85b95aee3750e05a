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
  /// A page that cannot be read explains nothing.
  explicit Manual(const std::filesystem::path& page);

  /// A URI of the page and the line of the code, `file:///…/diagnostics.md#L12`; empty where it
  /// explains no such code.
  [[nodiscard]] std::string linkTo(std::string_view code) const;

private:
  std::string uri;
  std::map<std::string, unsigned, std::less<>> lines; ///< of the headings, counted from 1
};

} // namespace proskill::lsp
