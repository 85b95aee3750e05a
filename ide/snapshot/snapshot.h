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

/// The texts of an editor at one moment, and what analysis says of them.
namespace proskill::ide {

/// The cells of a notebook are texts that have no files. The text of a notebook itself is nobody's:
/// it includes the cells, so that they are one program, and no answer ever speaks of it.
enum class TextKind : std::uint8_t { File, Cell, Notebook };

/// A text as an editor holds it; its file may not exist.
struct OpenText {
  std::string uri; ///< as the client spells it
  std::int64_t version = 0;
  syntax::Document document;
  TextKind kind = TextKind::File;
};

using OpenTexts = std::map<std::filesystem::path, OpenText>;

/// A program and what is known of it. What takes long is computed when it is first asked for, once,
/// by whoever asks first.
class AnalysedProgram {
  std::shared_ptr<const analysis::Program> shared; ///< what was computed of it may live longer

public:
  /// \param earlier the program before some edits, null where it is not known: what still holds of
  ///        it is not computed again
  AnalysedProgram(analysis::Program loaded, analysis::flow::Settings settings,
                  const AnalysedProgram* earlier = nullptr);
  AnalysedProgram(const AnalysedProgram&) = delete;
  AnalysedProgram& operator=(const AnalysedProgram&) = delete;

  const analysis::Program& program;
  const analysis::Analysis analysis;
  const analysis::flow::Settings settings;

  /// Which values a variable can have where; null in a program with errors.
  [[nodiscard]] std::shared_ptr<const KnownFlow> flow() const;
  /// The same where it is known already; null else. For who cannot wait.
  [[nodiscard]] std::shared_ptr<const KnownFlow> flowIfKnown() const;
  /// Gives back its memory, which is most of a program's. Who asks for it has it computed again;
  /// the findings are known still.
  void forgetFlow() const;
  /// Somebody wanted the flow, and did not wait for it. Any thread.
  void missFlow() const { missedFlow = true; }
  /// What somebody missed is there now: true once.
  [[nodiscard]] bool takeMissedFlow() const { return flowIfKnown() && missedFlow.exchange(false); }
  /// All that `proskill check` tells of the program, weighed by its settings.
  [[nodiscard]] const std::vector<syntax::Diagnostic>& findings() const;

private:
  using Diagnostics = std::vector<syntax::Diagnostic>;

  /// All that was known of the flow of a program: what is kept for the next one that differs in
  /// white space and comments only, also where programs with errors come in between.
  struct FlowMemory {
    std::shared_ptr<const analysis::Program> program;
    std::shared_ptr<const KnownFlow> flow; ///< null: it has errors, or the flow was forgotten
    std::shared_ptr<const Diagnostics> findings;
  };
  using Memory = std::shared_ptr<const FlowMemory>;

  [[nodiscard]] std::shared_ptr<const Diagnostics> flowFindings() const;
  [[nodiscard]] Memory memory() const;
  [[nodiscard]] static Memory withoutFlow(const Memory& memory);
  void takeFlow(const AnalysedProgram& earlier);
  void noteFlowFindings(Diagnostics found) const;

  const bool flows;             ///< it has a flow, known or not
  mutable std::mutex computing; ///< the flow
  mutable std::atomic<bool> missedFlow = false;
  mutable analysis::Once flowFindingsOnce;
  mutable std::mutex mutex; ///< of what follows
  mutable std::shared_ptr<const KnownFlow> knownFlow;
  mutable Memory known;      ///< of this program
  mutable Memory remembered; ///< of one before it, until this one's own is known; may be null
  mutable analysis::Once findingsOnce;
  mutable std::vector<syntax::Diagnostic> knownFindings;
};

/// How the findings of the program of a root file are weighed. Any thread may call it.
using SettingsOf = std::function<analysis::flow::Settings(const std::filesystem::path& root)>;

/// A file within the program that it belongs to: what a feature looks at. Keeps all alive that it
/// refers to.
struct View {
  std::shared_ptr<const AnalysedProgram> owner;
  analysis::FileId file = 0;

  [[nodiscard]] const analysis::Program& program() const { return owner->program; }
  [[nodiscard]] const analysis::Analysis& analysis() const { return owner->analysis; }
  [[nodiscard]] const analysis::Index& index() const { return owner->analysis.index; }
  [[nodiscard]] const syntax::Document& document() const { return program().files[file].document; }
  [[nodiscard]] const std::string& text() const { return document().text(); }
};

/// Of open texts alone.
[[nodiscard]] std::shared_ptr<const IncludeGraph> graphOf(const analysis::FileSystem& disk,
                                                          const OpenTexts& open);

/// Never changes; programs are analysed when they are first asked for, once, by whoever asks first.
/// Any thread may use it.
class Snapshot {
public:
  /// Where nobody says how findings are weighed, it is as their table says.
  Snapshot(std::shared_ptr<const analysis::FileSystem> disk, OpenTexts open,
           std::shared_ptr<const IncludeGraph> graph, SettingsOf settings = nullptr);

  /// The same moment after an edit: programs that the edit does not touch are kept, and of the
  /// others what still holds of them.
  [[nodiscard]] std::shared_ptr<const Snapshot>
  with(OpenTexts open, std::shared_ptr<const IncludeGraph> graph) const;
  /// Programs before the edits, which were needed until those after them were analysed. To destroy
  /// them takes a while: nobody should wait for it. Each is given once.
  [[nodiscard]] std::vector<std::shared_ptr<const AnalysedProgram>> takeReplaced() const;

  /// Somebody missed the flow of a program with open texts, which is known by now: true once.
  [[nodiscard]] bool takeMissedFlow() const;

  [[nodiscard]] const OpenTexts& open() const { return texts; }
  /// Of a text that is open, or of a file.
  [[nodiscard]] TextKind kindOf(const std::filesystem::path& name) const {
    const auto found = texts.find(name);
    return found == texts.end() ? TextKind::File : found->second.kind;
  }
  /// Every file that is open or in the workspace. A file has one name in all that a snapshot gives,
  /// whatever links lead to it: the one that the editor opened it by, else that in the workspace.
  [[nodiscard]] auto files() const {
    return graph->files() |
           std::views::transform([](const auto& file) -> const auto& { return file->name; });
  }
  [[nodiscard]] const std::shared_ptr<const IncludeGraph>& includes() const { return graph; }
  /// The same files, with what each includes.
  [[nodiscard]] const std::vector<IncludeGraph::File>& knownFiles() const { return graph->files(); }
  [[nodiscard]] bool knows(const std::filesystem::path& file) const { return graph->named(file); }
  [[nodiscard]] bool isKnown(std::string_view canonical) const { return graph->find(canonical); }
  /// The name of the file at a path.
  [[nodiscard]] std::filesystem::path nameOf(const std::filesystem::path& path) const;
  /// As the editor holds it, or else the disk, or why it cannot be read.
  [[nodiscard]] std::expected<std::string, std::string>
  textOf(const std::filesystem::path& path) const;
  [[nodiscard]] std::expected<syntax::Document, std::string>
  documentOf(const std::filesystem::path& path) const;
  /// What tells the file at a path from others, open or not.
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const {
    return disk->canonical(path);
  }
  /// Those of the files that are the root of a program.
  [[nodiscard]] std::vector<std::filesystem::path> roots() const { return graph->roots(); }
  /// The file in each program that it belongs to, one a root; a file that nothing includes is its
  /// own root.
  [[nodiscard]] std::vector<View> views(const std::filesystem::path& file) const;
  /// The same, one after the other: of hundreds not all need be held.
  void eachView(const std::filesystem::path& file,
                const std::function<void(const View&)>& visit) const;
  /// The first of them.
  [[nodiscard]] View view(const std::filesystem::path& file) const;
  /// It is the first program of an open text: features look into it.
  [[nodiscard]] bool isLookedAt(const AnalysedProgram& analysed) const;

private:
  /// Analysed at most once, whoever comes first.
  struct Entry {
    analysis::Once once;
    std::shared_ptr<const AnalysedProgram> program;
    std::shared_ptr<const AnalysedProgram> earlier; ///< until it is analysed; may be null
  };
  using Entries = std::unordered_map<std::string, std::shared_ptr<Entry>>;
  /// Programs none of whose files is open: an edit, which touches none of them, does not look at
  /// them. In a large workspace there are many, of which those that were used last are kept.
  struct ClosedPrograms {
    static constexpr std::size_t kMostBytes = 1 << 20; ///< of their texts

    void put(const std::string& root, const std::shared_ptr<Entry>& entry);

    std::mutex mutex;
    LruCache<std::shared_ptr<Entry>> entries{kMostBytes};
  };

  std::optional<View> viewIn(const std::filesystem::path& root,
                             const std::filesystem::path& file) const;
  std::shared_ptr<const AnalysedProgram> program(const std::filesystem::path& root) const;
  std::shared_ptr<Entry> entryOf(const std::string& root) const;
  void analyse(const std::shared_ptr<Entry>& entry, const std::filesystem::path& root) const;
  /// \param changed files of which something else is known or open now, by any of their names
  void takeOpenPrograms(const Snapshot& before, const std::vector<std::string_view>& changed);
  void takeClosedPrograms(const Snapshot& before, const std::vector<std::string_view>& changed);

  std::shared_ptr<const analysis::FileSystem> disk;
  OpenTexts texts;
  std::shared_ptr<const IncludeGraph> graph;
  SettingsOf settings;
  mutable std::mutex mutex;
  mutable Entries entries; ///< by the names of their roots
  /// Of all snapshots with the same files, open or not.
  std::shared_ptr<ClosedPrograms> closed = std::make_shared<ClosedPrograms>();
  mutable std::vector<std::shared_ptr<const AnalysedProgram>> replaced;
  mutable analysis::Once lookedAtOnce;
  mutable std::unordered_set<std::string> lookedAt; ///< the roots of programs
};

} // namespace proskill::ide
