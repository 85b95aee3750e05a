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

/// The files that an editor knows, and their includes.
namespace proskill::ide {

/// A file that is open or in the workspace.
struct KnownFile {
  struct Include {
    std::string path;      ///< resolved from the text, in normal form
    std::string canonical; ///< of the file at this path

    friend bool operator==(const Include&, const Include&) = default;
  };

  std::filesystem::path name; ///< the one of its names that the editor uses
  std::string canonical;      ///< identifies the file
  std::vector<Include> includes;
  FileNames names{}; ///< only if it is not open

  friend bool operator==(const KnownFile&, const KnownFile&) = default;
};

/// An open text. \param canonical name of the file
[[nodiscard]] KnownFile knownText(const analysis::FileSystem& files, std::filesystem::path name,
                                  std::string canonical, const syntax::Document& document);
/// A file that is not open, with its names.
[[nodiscard]] KnownFile knownFile(const analysis::FileSystem& files, std::filesystem::path name,
                                  std::string canonical, const syntax::Document& document);

/// Whether the includes of the document are those known for the file.
[[nodiscard]] bool includesAsBefore(const KnownFile& file, const syntax::Document& document);

/// The includes of a document, resolved against its own path.
[[nodiscard]] std::vector<std::filesystem::path> includesOf(const std::filesystem::path& file,
                                                            const syntax::Document& document);

/// An immutable graph; changed graphs share unchanged parts. Thread-safe. Files are looked up by
/// name.
class IncludeGraph {
public:
  using Path = std::filesystem::path;
  using File = std::shared_ptr<const KnownFile>;

  /// If a file occurs several times, its last entry counts.
  explicit IncludeGraph(std::vector<File> files = {});

  /// A graph in which this file is replaced or added.
  [[nodiscard]] std::shared_ptr<const IncludeGraph> with(KnownFile file) const;
  [[nodiscard]] std::shared_ptr<const IncludeGraph> without(std::string_view canonical) const;

  /// The canonical names of the files that differ between the graphs.
  [[nodiscard]] std::vector<std::string_view> differenceTo(const IncludeGraph& other) const;

  /// Ordered by canonical name.
  [[nodiscard]] const std::vector<File>& files() const { return all; }
  /// Null if the file is unknown.
  [[nodiscard]] const KnownFile* find(std::string_view canonical) const;
  [[nodiscard]] const KnownFile* named(const Path& name) const;

  /// The files that are roots of programs.
  [[nodiscard]] std::vector<Path> roots() const;
  /// The roots of the programs that contain a file. A file that nothing includes is its own root.
  [[nodiscard]] std::vector<Path> rootsOf(const Path& file) const;

private:
  using Indices = std::vector<std::uint32_t>; ///< into `all`

  struct Edges {
    std::unordered_map<std::string_view, std::uint32_t> byName;
    /// By canonical name of every included file, known or not.
    std::unordered_map<std::string_view, Indices> includers;
  };

  [[nodiscard]] const Edges& edges() const;
  [[nodiscard]] std::string_view canonicalOf(const Path& name) const;

  std::vector<File> all;
  mutable analysis::Once once;
  mutable Edges known; ///< computed on demand, since most edits do not need it
};

} // namespace proskill::ide
