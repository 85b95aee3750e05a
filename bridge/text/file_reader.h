#pragma once

#include "analysis/program/file_system.h"
#include "bridge/text/word.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace proskill::bridge {

inline constexpr std::size_t kMostFiles = 100;
inline constexpr std::size_t kLargestText = 4 << 20; ///< bytes

/// Reads a file and what it includes, each file once. `parse` makes of a text and its path a value
/// with `includes`, or the first error; `add` gets these values, those of included files first.
template <class Parse, class Add> class FileReader {
public:
  FileReader(const analysis::FileSystem& disk, Parse parse, Add add)
      : disk(disk), parse(std::move(parse)), add(std::move(add)) {}

  void root(const std::filesystem::path& path) { file(path, {path, 1, 1}); }

  Errors errors;
  std::vector<Word> missing; ///< includes of files that cannot be read

private:
  void file(const std::filesystem::path& path, const Place& from) {
    const auto canonical = disk.canonical(path);
    if (std::ranges::find(open, canonical) != open.end())
      return fail(from, fmt::format("`{}` includes itself", path.generic_string()));
    if (seen.contains(canonical)) return;
    if (seen.size() == kMostFiles) return fail(from, "too many files");
    const auto bytes = disk.read(path);
    if (!bytes) return unreadable(path, from, bytes.error());
    seen.insert(canonical);
    if (bytes->size() > kLargestText) return fail(from, "the file is larger than 4 MiB");
    auto parsed = parse(*bytes, path);
    if (!parsed) return errors.push_back(parsed.error());
    open.push_back(canonical);
    for (const auto& target : parsed->includes) include(target, path);
    open.pop_back();
    add(*std::move(parsed));
  }

  void include(const Word& target, const std::filesystem::path& path) {
    if (std::filesystem::path(target.text).is_absolute())
      return fail(target.place, "the path of `include` must be relative");
    file(path.parent_path() / target.text, target.place);
  }

  void unreadable(const std::filesystem::path& path, const Place& from, const std::string& why) {
    auto message = fmt::format("cannot read `{}`: {}", path.generic_string(), why);
    if (open.empty()) return fail(from, std::move(message));
    missing.push_back({std::move(message), from});
  }

  void fail(const Place& place, std::string message) {
    errors.push_back({place, std::move(message)});
  }

  const analysis::FileSystem& disk;
  Parse parse;
  Add add;
  std::vector<std::filesystem::path> open;
  std::set<std::filesystem::path> seen;
};

} // namespace proskill::bridge
