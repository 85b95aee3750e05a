#pragma once

#include "ide/snapshot/snapshot.h"
#include "lsp/protocol/client.h"
#include "lsp/workspace/file_cache.h"
#include "report/program_settings.h"

#include <expected>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <unordered_map>

namespace proskill::lsp {

/// The program files of some folders, with their includes.
struct FolderContents {
  std::vector<ide::KnownFile> files;
};

/// An open text that programs read as data, such as a platform file.
struct DataText {
  std::string uri;
  std::int64_t version = 0;
  std::string text;
};
using DataTexts = std::map<std::filesystem::path, DataText>;

/// An open document of which the server does not have the client's exact text.
struct InexactText {
  std::string uri;
  ide::TextKind kind = ide::TextKind::File;
  /// An edit could not be applied: the text is unknown until the client sends all of it. Otherwise
  /// the client's text contains half a character, which reads as U+FFFD.
  bool isLost = false;
};
using InexactTexts = std::map<std::filesystem::path, InexactText>;

/// The text of this path if it is lost; otherwise null.
[[nodiscard]] const InexactText* lostIn(const InexactTexts& texts,
                                        const std::filesystem::path& path);
[[nodiscard]] std::set<std::filesystem::path> lostPaths(const InexactTexts& texts);

/// The texts that the client has open and the files of its folders. The main thread changes them
/// and takes snapshots.
class Workspace {
public:
  explicit Workspace(std::shared_ptr<const analysis::FileSystem> disk);

  /// \pre the encoding has been negotiated
  void setEncoding(syntax::Encoding encoding) { this->encoding = encoding; }
  /// Reports style hints, whatever the programs' own settings are.
  void setStyle(bool style);

  using Outcome = std::expected<std::filesystem::path, std::string>;
  /// The path of the text that was opened, changed or closed, or an error in the message. A change
  /// of a part that does not fit, or that contains half a character, drops the text: a wrong text
  /// would give wrong answers. The text is then lost until it is closed, or a change replaces all
  /// of it; changes of parts have no effect. \param hasHalves the message contains halves of
  /// characters, which were replaced by U+FFFD
  Outcome open(const Json& params, ide::TextKind kind = ide::TextKind::File,
               bool hasHalves = false);
  Outcome change(const Json& params, bool hasHalves = false);
  Outcome close(const Json& params);
  /// A text was saved. This matters only for programs that include the file from disk.
  Outcome saved(const Json& params);

  /// Whether a file is read as data by those who need it, and not as a program.
  [[nodiscard]] static bool isData(const std::filesystem::path& path);
  /// A data file is opened, changed or closed in the client. Changes replace the whole text.
  Outcome openData(const Json& params);
  Outcome changeData(const Json& params);
  Outcome closeData(const Json& params);
  [[nodiscard]] const DataTexts& dataTexts() const { return data; }

  [[nodiscard]] const InexactTexts& inexactTexts() const { return inexact; }
  /// Whether an edit of parts is in a whole text already that came before it.
  [[nodiscard]] bool isIncluded(const Json& params) const;

  /// Combines the cells of a notebook to one program, in this order.
  /// \return whether the program has changed
  bool join(const std::filesystem::path& notebook, const std::string& uri,
            const std::vector<std::filesystem::path>& cells);
  /// Closes a text if it is open.
  void close(const std::filesystem::path& path);

  using OnFile = std::function<void(std::size_t done, std::size_t all)>;
  /// Parses the files of folders. Thread-safe; has no effect until the result is added.
  [[nodiscard]] FolderContents read(const std::vector<std::filesystem::path>& folders,
                                    const OnFile& onFile) const;
  void add(FolderContents contents);
  /// Removes folders that the client no longer has, except subfolders that remain.
  void forget(const std::vector<std::filesystem::path>& folders,
              const std::vector<std::filesystem::path>& staying);

  /// The errors in settings files that apply to open texts, for the user.
  [[nodiscard]] std::map<std::filesystem::path, report::SettingsMistake> mistakes() const;

  /// Whether answers may depend on a file that has changed: one of a program, settings, or a
  /// platform.
  [[nodiscard]] bool dependsOn(const std::filesystem::path& path) const;
  /// Files on disk that are new or have changed; open files are not read.
  void readFiles(const std::vector<std::filesystem::path>& paths);

  [[nodiscard]] std::shared_ptr<const ide::Snapshot> snapshot() const { return current; }

private:
  using Path = std::filesystem::path;

  [[nodiscard]] bool isHeld(std::string_view canonical) const;
  [[nodiscard]] std::string identityOf(const Path& path) const;
  [[nodiscard]] std::optional<ide::KnownFile> onDisk(const Path& path);
  void noteText(const Path& path);
  Outcome setData(const Path& path, DataText text);
  Outcome restore(const Path& path, const Json& params, bool hasHalves);
  void drop(const Path& path);
  [[nodiscard]] std::optional<Path> otherTextOf(std::string_view canonical) const;
  void refresh();
  void startAfresh();

  std::shared_ptr<const analysis::FileSystem> direct; ///< for files that are read only once
  std::shared_ptr<FileCache> disk;
  syntax::Encoding encoding = syntax::Encoding::Utf16;
  bool style = false;
  ide::OpenTexts texts;
  DataTexts data;
  InexactTexts inexact;
  /// The version with which a whole text came last, instead of an edit. VS Code sends an edit by
  /// both registrations, the whole text first: edits up to its version are in it already.
  std::map<Path, std::int64_t> wholeVersions;
  /// The canonical name of each text's file. A text that was opened while its file was open by
  /// another name is separate until the other one is closed.
  std::map<Path, std::string> identities;
  std::unordered_map<std::string, Path> names; ///< of files on disk, by their canonical names
  std::shared_ptr<const ide::IncludeGraph> graph = std::make_shared<const ide::IncludeGraph>();
  std::shared_ptr<const ide::Snapshot> current;
};

/// Whether a folder holds hidden, generated or installed files, by its name.
[[nodiscard]] bool isSkippedFolder(const std::filesystem::path& folder);
[[nodiscard]] bool isProgramFile(const std::filesystem::path& path);
/// Every program file below a folder, except in folders that are skipped. Empty for a file.
[[nodiscard]] std::set<std::filesystem::path> programFiles(const std::filesystem::path& folder);

} // namespace proskill::lsp
