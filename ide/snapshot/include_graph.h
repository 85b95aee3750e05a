#pragma once

#include "analysis/program/file_system.h"
#include "analysis/program/once.h"
#include "ide/snapshot/file_names.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

/// The files that an editor knows, and which of them includes which.
namespace proskill::ide {

/// A file that is open or in the workspace.
struct KnownFile {
  struct Include {
    std::string path;      ///< as it follows from the text, normal
    std::string canonical; ///< of the file that is there

    friend bool operator==(const Include&, const Include&) = default;
  };

  std::filesystem::path name; ///< of all its names the one that the editor uses
  std::string canonical;      ///< what tells it from other files
  std::vector<Include> includes;
  FileNames names{}; ///< of a text that is not open

  friend bool operator==(const KnownFile&, const KnownFile&) = default;
};

/// Of a text that is open. \param canonical of the file
[[nodiscard]] KnownFile knownText(const analysis::FileSystem& files, std::filesystem::path name,
                                  std::string canonical, const syntax::Document& document);
/// The same of one that is not, with its names.
[[nodiscard]] KnownFile knownFile(const analysis::FileSystem& files, std::filesystem::path name,
                                  std::string canonical, const syntax::Document& document);

/// The document includes what was known of the file.
[[nodiscard]] bool includesAsBefore(const KnownFile& file, const syntax::Document& document);

/// What a document includes, resolved against its own path.
[[nodiscard]] std::vector<std::filesystem::path> includesOf(const std::filesystem::path& file,
                                                            const syntax::Document& document);

/// Never changes: what changes is a new one, which shares with the old one what both know. Any
/// thread may use it. Files are asked for by their names.
class IncludeGraph {
public:
  using Path = std::filesystem::path;
  using File = std::shared_ptr<const KnownFile>;

  /// Of files that are the same the last counts.
  explicit IncludeGraph(std::vector<File> files = {});

  /// With this file in place of what was known of it.
  [[nodiscard]] std::shared_ptr<const IncludeGraph> with(KnownFile file) const;
  [[nodiscard]] std::shared_ptr<const IncludeGraph> without(std::string_view canonical) const;

  /// The canonical names of the files of which the other graph knows something else.
  [[nodiscard]] std::vector<std::string_view> differenceTo(const IncludeGraph& other) const;

  /// In the order of their canonical names.
  [[nodiscard]] const std::vector<File>& files() const { return all; }
  /// Null where no file is known there.
  [[nodiscard]] const KnownFile* find(std::string_view canonical) const;
  [[nodiscard]] const KnownFile* named(const Path& name) const;

  /// The files that are the root of a program.
  [[nodiscard]] std::vector<Path> roots() const;
  /// The roots of the programs that a file belongs to; one that nothing includes is its own root.
  [[nodiscard]] std::vector<Path> rootsOf(const Path& file) const;

private:
  using Indices = std::vector<std::uint32_t>; ///< of `all`

  struct Edges {
    std::unordered_map<std::string_view, std::uint32_t> byName;
    /// Of every file that is included, known or not, by its canonical name.
    std::unordered_map<std::string_view, Indices> includers;
  };

  [[nodiscard]] const Edges& edges() const;
  [[nodiscard]] std::string_view canonicalOf(const Path& name) const;

  std::vector<File> all;
  mutable analysis::Once once;
  mutable Edges known; ///< made when first asked for: most edits never ask
};

} // namespace proskill::ide
