#pragma once

#include "analysis/names/symbols.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::ide {

/// The searchable names of the definitions of a file, from its text alone. Inputs and tags are
/// found only together with the names of their skills. The representation is small, because there
/// is one for each file of a folder.
class FileNames {
public:
  struct Name {
    analysis::SymbolKind kind{};
    bool isInner = false;      ///< it is inside of the definition `owner`
    std::uint32_t owner = 0;   ///< index of the enclosing definition
    std::uint32_t letters = 0; ///< index of its first letter
    std::uint32_t length = 0;
    syntax::Range at;

    friend bool operator==(const Name&, const Name&) = default;
  };

  FileNames() = default; ///< no names
  explicit FileNames(const syntax::Document& document);

  /// In the order of `SymbolTable`.
  [[nodiscard]] const std::vector<Name>& all() const { return names; }
  [[nodiscard]] std::string_view wordOf(const Name& name) const {
    return std::string_view(letters).substr(name.letters, name.length);
  }
  /// \pre it is inside of a definition
  [[nodiscard]] std::string_view ownerOf(const Name& name) const {
    return wordOf(names[name.owner]);
  }

  friend bool operator==(const FileNames&, const FileNames&) = default;

private:
  std::string letters; ///< of all names
  std::vector<Name> names;
};

} // namespace proskill::ide
