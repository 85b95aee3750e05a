#pragma once

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::codegen {

/// Gives out names within one Fiacre name space. Each thing always gets the same name: its
/// preferred name or, if that is reserved or taken, the preferred name followed by as many `_` as
/// necessary.
class UniqueNames {
public:
  /// A thing that did not get its preferred name.
  struct Renaming {
    std::string preferred;
    std::string name;
  };

  UniqueNames() = default;
  /// \param words names that the generator itself uses
  explicit UniqueNames(std::initializer_list<std::string_view> words);

  /// The name of the thing that `kind` and `parts` identify. Its preferred name is the parts,
  /// joined by `_`.
  const std::string& of(std::string_view kind, std::initializer_list<std::string_view> parts);
  const std::string& of(std::string_view kind, std::string_view preferred) {
    return of(kind, {preferred});
  }

  [[nodiscard]] const std::vector<Renaming>& renamings() const { return renamed; }

private:
  std::map<std::string, std::string, std::less<>> names;
  std::set<std::string, std::less<>> taken;
  std::vector<Renaming> renamed;
};

} // namespace proskill::codegen
