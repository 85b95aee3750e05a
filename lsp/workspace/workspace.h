#pragma once

#include "ide/snapshot/snapshot.h"
#include "lsp/protocol/client.h"
#include "lsp/workspace/file_cache.h"
#include "lsp/workspace/program_settings.h"

#include <expected>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <unordered_map>

namespace proskill::lsp {

/// The program files of some folders, each with what it includes.
struct FolderContents {
  std::vector<ide::KnownFile> files;
};

/// The texts that the client has open and the files of its folders. The main thread changes them,
/// and takes snapshots.
class Workspace {
public:
  explicit Workspace(std::shared_ptr<const analysis::FileSystem> disk);

  /// \pre `Encoding` is negotiated
  void setEncoding(syntax::Encoding encoding) { this->encoding = encoding; }
  /// Reports style hints, whatever the programs' own settings say.
  void setStyle(bool style);

  using Outcome = std::expected<std::filesystem::path, std::string>;
  /// The path of the text that was opened, changed or closed, or what is wrong with the message. A
  /// change that does not fit the text drops the text: a wrong text would give wrong answers until
  /// it is closed.
  Outcome open(const Json& params, ide::TextKind kind = ide::TextKind::File);
  Outcome change(const Json& params);
  Outcome close(const Json& params);
  /// Nothing changes but where the file is that others include from disk.
  Outcome saved(const Json& params);

  /// Makes the cells of a notebook one program, in this order.
  /// \return it is another one than before
  bool join(const std::filesystem::path& notebook, const std::string& uri,
            const std::vector<std::filesystem::path>& cells);
  /// A text that may be open.
  void close(const std::filesystem::path& path);

  using OnFile = std::function<void(std::size_t done, std::size_t all)>;
  /// The programs of folders, each file parsed. Any thread; nothing changes until they are added.
  [[nodiscard]] FolderContents read(const std::vector<std::filesystem::path>& folders,
                                    const OnFile& onFile) const;
  void add(FolderContents contents);
  /// Folders that are none of the client's any more, but for what lies in one that stays.
  void forget(const std::vector<std::filesystem::path>& folders,
              const std::vector<std::filesystem::path>& staying);

  /// What is wrong with files of settings that apply to open texts, in words for the user.
  [[nodiscard]] std::map<std::filesystem::path, SettingsMistake> mistakes() const;

  /// Files on disk that changed or are known now; those that are open are not read.
  void readFiles(const std::vector<std::filesystem::path>& paths);

  [[nodiscard]] std::shared_ptr<const ide::Snapshot> snapshot() const { return current; }

private:
  using Path = std::filesystem::path;

  [[nodiscard]] bool isHeld(std::string_view canonical) const;
  [[nodiscard]] std::string identityOf(const Path& path) const;
  [[nodiscard]] std::optional<ide::KnownFile> onDisk(const Path& path);
  void noteText(const Path& path);
  void drop(const Path& path);
  [[nodiscard]] std::optional<Path> otherTextOf(std::string_view canonical) const;
  void refresh();
  void startAfresh();

  std::shared_ptr<const analysis::FileSystem> direct; ///< for files that are read once
  std::shared_ptr<FileCache> disk;
  syntax::Encoding encoding = syntax::Encoding::Utf16;
  bool style = false;
  ide::OpenTexts texts;
  /// Which file each text is, by its canonical name. A text that was opened when its file was open
  /// by another name is a text of its own, until that one is closed.
  std::map<Path, std::string> identities;
  std::unordered_map<std::string, Path> names; ///< of files on disk, by their canonical names
  std::shared_ptr<const ide::IncludeGraph> graph = std::make_shared<const ide::IncludeGraph>();
  std::shared_ptr<const ide::Snapshot> current;
};

/// Every `.proskill` file below a folder, without what is hidden, generated or installed.
[[nodiscard]] std::set<std::filesystem::path> programFiles(const std::filesystem::path& folder);

} // namespace proskill::lsp
