#pragma once

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::codegen {

/// Gives out the names of one Fiacre name space. Each thing has one name, the same whenever it is
/// asked for: the preferred one, or, where Fiacre reserves that or another thing has it, with as
/// many `_` behind it as it takes.
class UniqueNames {
public:
  /// What had to be called otherwise.
  struct Renaming {
    std::string preferred;
    std::string name;
  };

  UniqueNames() = default;
  /// Words that belong to the generator itself.
  explicit UniqueNames(std::initializer_list<std::string_view> words);

  /// `kind` and `parts` say which thing; the parts, joined by `_`, are its preferred name.
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
