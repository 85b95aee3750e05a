#pragma once

#include "analysis/names/symbols.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::ide {

/// The names of the definitions in a file that are searched for, of its text alone. Inputs and tags
/// are found under the names of their skills. It takes little: of each file of a folder there is
/// one.
class FileNames {
public:
  struct Name {
    analysis::SymbolKind kind{};
    bool isInner = false;      ///< it has an owner, which is `owner`
    std::uint32_t owner = 0;   ///< the index of the definition that it is inside of
    std::uint32_t letters = 0; ///< where they begin
    std::uint32_t length = 0;
    syntax::Range at;

    friend bool operator==(const Name&, const Name&) = default;
  };

  FileNames() = default; ///< none
  explicit FileNames(const syntax::Document& document);

  /// In the order of `SymbolTable`.
  [[nodiscard]] const std::vector<Name>& all() const { return names; }
  [[nodiscard]] std::string_view wordOf(const Name& name) const {
    return std::string_view(letters).substr(name.letters, name.length);
  }
  /// \pre it is inside of another
  [[nodiscard]] std::string_view ownerOf(const Name& name) const {
    return wordOf(names[name.owner]);
  }

  friend bool operator==(const FileNames&, const FileNames&) = default;

private:
  std::string letters; ///< of all names
  std::vector<Name> names;
};

} // namespace proskill::ide
