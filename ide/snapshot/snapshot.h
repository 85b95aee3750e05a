#pragma once

#include "analysis/flow/inspect.h"
#include "analysis/program/once.h"
#include "ide/snapshot/include_graph.h"
#include "ide/snapshot/known_flow.h"
#include "ide/snapshot/lru_cache.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <ranges>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

/// The texts of an editor at one moment, with their analysis.
namespace proskill::ide {

/// Cells of a notebook are texts without files. The text of the notebook itself is internal: it
/// includes the cells, so that they form one program, and no answer refers to it.
enum class TextKind : std::uint8_t { File, Cell, Notebook };

/// A text that is open in an editor; its file need not exist.
struct OpenText {
  std::string uri; ///< as the client writes it
  std::int64_t version = 0;
  syntax::Document document;
  TextKind kind = TextKind::File;
};

using OpenTexts = std::map<std::filesystem::path, OpenText>;

/// A program with its analysis. Expensive results are computed once, on first access.
class AnalysedProgram {
  /// Shared, because results computed from it may live longer.
  std::shared_ptr<const analysis::Program> shared;

public:
  /// \param earlier the program before some edits, or null: its valid results are reused
  AnalysedProgram(analysis::Program loaded, analysis::flow::Settings settings,
                  const std::shared_ptr<const AnalysedProgram>& earlier = nullptr);
  AnalysedProgram(const AnalysedProgram&) = delete;
  AnalysedProgram& operator=(const AnalysedProgram&) = delete;

  const analysis::Program& program;
  const analysis::Analysis analysis;
  const analysis::flow::Settings settings;

  /// The flow of values; null for a program with errors.
  [[nodiscard]] std::shared_ptr<const KnownFlow> flow() const;
  /// The same without computing it; null if it is not known yet.
  [[nodiscard]] std::shared_ptr<const KnownFlow> flowIfKnown() const;
  /// For a program with errors, its last version without errors. Null if there was none, if its
  /// flow was forgotten, and for a program without errors.
  [[nodiscard]] std::shared_ptr<const AnalysedProgram> beforeErrors() const;
  /// Frees the memory of the flow, which is most of a program's. It is computed again on the next
  /// access; the findings stay known. That of the last version without errors is freed, too.
  void forgetFlow() const;
  /// Notes that somebody needed the flow but could not wait for it. Thread-safe.
  void missFlow() const { missedFlow = true; }
  /// Returns true once when a flow that was missed has become known.
  [[nodiscard]] bool takeMissedFlow() const { return flowIfKnown() && missedFlow.exchange(false); }
  /// All diagnostics that `proskill check` reports, with its settings.
  [[nodiscard]] const std::vector<syntax::Diagnostic>& findings() const;

private:
  using Diagnostics = std::vector<syntax::Diagnostic>;

  /// The flow of a program, kept for the next version that differs only in white space and
  /// comments, even if versions with errors come in between.
  struct FlowMemory {
    std::shared_ptr<const analysis::Program> program;
    /// null: the program has errors, or the flow was dropped.
    std::shared_ptr<const KnownFlow> flow;
    std::shared_ptr<const Diagnostics> findings;
  };
  using Memory = std::shared_ptr<const FlowMemory>;

  [[nodiscard]] std::shared_ptr<const Diagnostics> flowFindings() const;
  [[nodiscard]] Memory memory() const;
  [[nodiscard]] static Memory withoutFlow(const Memory& memory);
  void takeFlow(const AnalysedProgram& earlier);
  void noteFlowFindings(Diagnostics found) const;

  const bool flows;             ///< whether it has a flow, known or not
  mutable std::mutex computing; ///< held while the flow is computed
  mutable std::atomic<bool> missedFlow = false;
  mutable analysis::Once flowFindingsOnce;
  mutable std::mutex mutex; ///< for the members below
  mutable std::shared_ptr<const KnownFlow> knownFlow;
  mutable Memory known;      ///< of this program
  mutable Memory remembered; ///< of an earlier version, until this one's own is known; may be null
  mutable std::shared_ptr<const AnalysedProgram> lastGood; ///< see `beforeErrors`
  mutable analysis::Once findingsOnce;
  mutable std::vector<syntax::Diagnostic> knownFindings;
};

/// Returns the severities of findings for the program with this root. Thread-safe.
using SettingsOf = std::function<analysis::flow::Settings(const std::filesystem::path& root)>;

/// A file within one of its programs; the input of features. Keeps everything alive to which it
/// refers.
struct View {
  std::shared_ptr<const AnalysedProgram> owner;
  analysis::FileId file = 0;

  [[nodiscard]] const analysis::Program& program() const { return owner->program; }
  [[nodiscard]] const analysis::Analysis& analysis() const { return owner->analysis; }
  [[nodiscard]] const analysis::Index& index() const { return owner->analysis.index; }
  [[nodiscard]] const syntax::Document& document() const { return program().files[file].document; }
  [[nodiscard]] const std::string& text() const { return document().text(); }
};

/// The graph of the open texts only.
[[nodiscard]] std::shared_ptr<const IncludeGraph> graphOf(const analysis::FileSystem& disk,
                                                          const OpenTexts& open);

/// Immutable. Programs are analysed once, on first access. Thread-safe.
class Snapshot {
public:
  /// \param settings empty: the severities of the table
  Snapshot(std::shared_ptr<const analysis::FileSystem> disk, OpenTexts open,
           std::shared_ptr<const IncludeGraph> graph, SettingsOf settings = nullptr);

  /// The snapshot after an edit. Reuses programs that the edit does not touch, and the valid
  /// results of the others.
  [[nodiscard]] std::shared_ptr<const Snapshot>
  with(OpenTexts open, std::shared_ptr<const IncludeGraph> graph) const;
  /// Destroying them takes long, so do it when no request waits.
  [[nodiscard]] std::vector<std::shared_ptr<const AnalysedProgram>> takeReplaced() const;

  /// Returns true once when the flow of a program with open texts that was missed has become known.
  [[nodiscard]] bool takeMissedFlow() const;

  [[nodiscard]] const OpenTexts& open() const { return texts; }
  /// The kind of an open text or a file.
  [[nodiscard]] TextKind kindOf(const std::filesystem::path& name) const {
    const auto found = texts.find(name);
    return found == texts.end() ? TextKind::File : found->second.kind;
  }
  /// All files that are open or in the workspace. Each file has one name in a snapshot, whatever
  /// links lead to it: the name by which the editor opened it, otherwise its name in the workspace.
  [[nodiscard]] auto files() const {
    return graph->files() |
           std::views::transform([](const auto& file) -> const auto& { return file->name; });
  }
  [[nodiscard]] const std::shared_ptr<const IncludeGraph>& includes() const { return graph; }
  /// The same files with their includes.
  [[nodiscard]] const std::vector<IncludeGraph::File>& knownFiles() const { return graph->files(); }
  [[nodiscard]] bool knows(const std::filesystem::path& file) const { return graph->named(file); }
  [[nodiscard]] bool isKnown(std::string_view canonical) const { return graph->find(canonical); }
  /// The name of the file at a path.
  [[nodiscard]] std::filesystem::path nameOf(const std::filesystem::path& path) const;
  /// The editor's text, otherwise the file's; or why it cannot be read.
  [[nodiscard]] std::expected<std::string, std::string>
  textOf(const std::filesystem::path& path) const;
  [[nodiscard]] std::expected<syntax::Document, std::string>
  documentOf(const std::filesystem::path& path) const;
  /// Whether there is a file, or an open text, at a path.
  [[nodiscard]] bool isFile(const std::filesystem::path& path) const {
    return texts.contains(nameOf(path)) || disk->isFile(path);
  }
  /// Files of the disk: see analysis::FileSystem.
  [[nodiscard]] std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder,
                                                              std::string_view extension) const {
    return disk->filesBelow(folder, extension);
  }
  /// The unique name of the file at a path, open or not.
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const {
    return disk->canonical(path);
  }
  /// The files that are roots of programs.
  [[nodiscard]] std::vector<std::filesystem::path> roots() const { return graph->roots(); }
  /// The file in each program that contains it, one view per root. Programs whose roots are open
  /// come first. A file that nothing includes is its own root.
  [[nodiscard]] std::vector<View> views(const std::filesystem::path& file) const;
  /// The same, one after the other, so that hundreds of programs need not be in memory together.
  void eachView(const std::filesystem::path& file,
                const std::function<void(const View&)>& visit) const;
  /// The first of these views.
  [[nodiscard]] View view(const std::filesystem::path& file) const;
  /// Whether it is the first program of an open text, which features use.
  [[nodiscard]] bool isLookedAt(const AnalysedProgram& analysed) const;

private:
  /// Analysed at most once.
  struct Entry {
    analysis::Once once;
    std::shared_ptr<const AnalysedProgram> program;
    std::shared_ptr<const AnalysedProgram> earlier; ///< until it is analysed; may be null
  };
  /// The roots of the programs that contain the file; those that are open come first.
  [[nodiscard]] std::vector<std::filesystem::path> rootsOf(const std::filesystem::path& file) const;
  using Entries = std::unordered_map<std::string, std::shared_ptr<Entry>>;
  /// Programs without open files. Edits do not affect them. There may be many in a large workspace;
  /// the most recently used are kept.
  struct ClosedPrograms {
    static constexpr std::size_t kMostBytes = 1 << 20; ///< total length of their texts

    void put(const std::string& root, const std::shared_ptr<Entry>& entry);

    std::mutex mutex;
    LruCache<std::shared_ptr<Entry>> entries{kMostBytes};
  };

  std::optional<View> viewIn(const std::filesystem::path& root,
                             const std::filesystem::path& file) const;
  std::shared_ptr<const AnalysedProgram> program(const std::filesystem::path& root) const;
  std::shared_ptr<Entry> entryOf(const std::string& root) const;
  void analyse(const std::shared_ptr<Entry>& entry, const std::filesystem::path& root) const;
  /// \param changed files that were edited, opened or closed, by any of their names
  void takeOpenPrograms(const Snapshot& before, const std::vector<std::string_view>& changed);
  void takeClosedPrograms(const Snapshot& before, const std::vector<std::string_view>& changed);

  std::shared_ptr<const analysis::FileSystem> disk;
  OpenTexts texts;
  std::shared_ptr<const IncludeGraph> graph;
  SettingsOf settings;
  mutable std::mutex mutex;
  mutable Entries entries; ///< by name of the root
  /// Shared by all snapshots with the same files, open or not.
  std::shared_ptr<ClosedPrograms> closed = std::make_shared<ClosedPrograms>();
  mutable std::vector<std::shared_ptr<const AnalysedProgram>> replaced;
  mutable analysis::Once lookedAtOnce;
  mutable std::unordered_set<std::string> lookedAt; ///< roots of programs
};

} // namespace proskill::ide
