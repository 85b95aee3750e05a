#pragma once

#include "ide/snapshot.h"
#include "lsp/client.h"
#include "lsp/program_settings.h"

#include <expected>
#include <functional>
#include <map>
#include <set>
#include <string>

namespace proskill::lsp {

/// The program files of some folders, each with what it includes.
struct FolderContents {
  ide::Includes files;
};

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
  /// Nothing changes but where the file is that others include from disk.
  Outcome saved(const Json& params);

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
  [[nodiscard]] const std::set<std::filesystem::path>& files() const { return known; }

private:
  void noteFile(const std::filesystem::path& path);
  void refresh(const std::filesystem::path& edited);
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
[[nodiscard]] std::set<std::filesystem::path> programFiles(const std::filesystem::path& folder);

} // namespace proskill::lsp
