#pragma once

#include "ide/snapshot.h"
#include "lsp/client.h"

#include <expected>
#include <set>

namespace proskill::lsp {

/// The texts that the client has open and the files of its folders: what the main thread changes,
/// and what snapshots are taken of.
class Workspace {
public:
  explicit Workspace(std::shared_ptr<const analysis::FileSystem> disk);

  /// \pre `Encoding` is negotiated
  void setEncoding(Encoding encoding) { this->encoding = encoding; }
  /// Hints of style are told, whatever the programs' own settings say.
  void setStyle(bool style);

  using Outcome = std::expected<std::filesystem::path, std::string>;
  /// The path of the text that was opened, changed or closed, or what is wrong with the message. A
  /// change that does not fit the text drops the text: a wrong text would give wrong answers until
  /// it is closed.
  Outcome open(const Json& params);
  Outcome change(const Json& params);
  Outcome close(const Json& params);

  /// Files on disk that changed or are known now; those that are open are not read.
  void readFiles(const std::vector<std::filesystem::path>& paths);

  [[nodiscard]] std::shared_ptr<const ide::Snapshot> snapshot() const { return current; }
  [[nodiscard]] const std::set<std::filesystem::path>& files() const { return known; }

private:
  Outcome apply(const std::filesystem::path& path, ide::OpenText& text, const Json& changes);
  void refresh();
  void startAfresh();
  void noteIncludes(const std::filesystem::path& path, const syntax::Document& document);

  std::shared_ptr<const analysis::FileSystem> disk;
  Encoding encoding = Encoding::Utf16;
  bool style = false;
  ide::OpenTexts texts;
  ide::Includes includes;
  std::set<std::filesystem::path> known; ///< every file of the folders
  std::shared_ptr<const ide::Snapshot> current;
};

/// Every `.proskill` file below a folder, without what is hidden, generated or installed.
[[nodiscard]] std::vector<std::filesystem::path> programFiles(const std::filesystem::path& folder);

} // namespace proskill::lsp
