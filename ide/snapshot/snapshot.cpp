#include "ide/snapshot/snapshot.h"

#include "analysis/names/reuse.h"
#include "ide/snapshot/fiacre_file.h"

#include <algorithm>
#include <optional>

namespace proskill::ide {

namespace {

namespace fs = std::filesystem;

/// The disk, overlaid with the open texts under any of their names.
class Overlay : public analysis::FileSystem {
public:
  Overlay(const analysis::FileSystem& disk, const Snapshot& snapshot)
      : disk(disk), snapshot(snapshot) {}

  [[nodiscard]] std::expected<std::string, std::string> read(const fs::path& path) const override {
    const auto* text = find(path);
    return text ? text->document.text() : disk.read(path);
  }
  [[nodiscard]] fs::path canonical(const fs::path& path) const override {
    return disk.canonical(path);
  }
  [[nodiscard]] fs::path nameOf(const fs::path& path) const override {
    return snapshot.nameOf(path);
  }
  [[nodiscard]] std::expected<syntax::Document, std::string>
  document(const fs::path& path) const override {
    const auto* text = find(path);
    return text ? text->document : disk.document(path);
  }

private:
  [[nodiscard]] const OpenText* find(const fs::path& path) const {
    const auto found = snapshot.open().find(nameOf(path));
    return found == snapshot.open().end() ? nullptr : &found->second;
  }

  const analysis::FileSystem& disk;
  const Snapshot& snapshot;
};

std::optional<analysis::FileId> fileIn(const analysis::Program& program, const fs::path& path) {
  auto found = std::ranges::find(program.files, path, &analysis::File::path);
  if (found == program.files.end()) return std::nullopt;
  return static_cast<analysis::FileId>(found - program.files.begin());
}

/// Whether the program was made from exactly these texts.
bool isCurrent(const AnalysedProgram& analysed, const OpenTexts& before, const OpenTexts& now) {
  return std::ranges::all_of(analysed.program.files, [&](const analysis::File& file) {
    auto old = before.find(file.path);
    auto fresh = now.find(file.path);
    if (old == before.end() || fresh == now.end()) return old == before.end() && fresh == now.end();
    return old->second.document.isSameAs(fresh->second.document);
  });
}

bool isOpen(const AnalysedProgram& analysed, const OpenTexts& texts) {
  return std::ranges::any_of(analysed.program.files,
                             [&](const analysis::File& file) { return texts.contains(file.path); });
}

/// Adds the names that are open in only one of the two.
void addOpened(std::vector<std::string_view>& names, const OpenTexts& these,
               const OpenTexts& others) {
  for (const auto& [name, text] : these)
    if (!others.contains(name)) names.push_back(name.native());
}

bool hasOneOf(const AnalysedProgram& analysed, const std::vector<std::string_view>& names) {
  return std::ranges::any_of(analysed.program.files, [&](const analysis::File& file) {
    auto isIt = [&](auto name) { return name == file.path.native() || name == file.canonical; };
    return std::ranges::any_of(names, isIt);
  });
}

/// The program of a file. A Fiacre model has no definitions, so only its text is loaded.
analysis::Program loaded(const Overlay& files, const fs::path& root) {
  if (!isFiacre(root)) return analysis::load(files, root);
  auto program = readFiacre(root, files.read(root).value_or(std::string())).program;
  program.files.front().canonical = files.canonical(root).native();
  return program;
}

} // namespace

AnalysedProgram::AnalysedProgram(analysis::Program loaded, analysis::flow::Settings settings,
                                 const std::shared_ptr<const AnalysedProgram>& earlier)
    : shared(std::make_shared<const analysis::Program>(std::move(loaded))),
      program(*shared),
      analysis(earlier ? analysis::analyse(program, {earlier->program, earlier->analysis})
                       : analysis::analyse(program)),
      settings(std::move(settings)),
      flows(analysis::flow::hasFlow(program, analysis)) {
  if (!earlier) return;
  takeFlow(*earlier);
  if (!flows) lastGood = earlier->flows ? earlier : earlier->beforeErrors();
}

/// Reuses the flow: white space and comments do not change it.
void AnalysedProgram::takeFlow(const AnalysedProgram& earlier) {
  remembered = earlier.memory();
  if (!remembered || !flows) return;
  const auto edit = analysis::changeBetween(*remembered->program, program);
  auto moved = edit ? analysis::movedByLayout(*remembered->findings, *edit) : std::nullopt;
  if (!moved) return;
  if (remembered->flow) {
    knownFlow = remembered->flow->after(edit->file, *edit->change.layout);
    if (!knownFlow) return;
  }
  flowFindingsOnce([&] { noteFlowFindings(std::move(*moved)); });
}

/// The memory of this program if known, otherwise that of its predecessor.
AnalysedProgram::Memory AnalysedProgram::memory() const {
  const std::lock_guard lock(mutex);
  return flows && known ? known : remembered;
}

AnalysedProgram::Memory AnalysedProgram::withoutFlow(const Memory& memory) {
  if (!memory || !memory->flow) return memory;
  return std::make_shared<const FlowMemory>(FlowMemory{memory->program, nullptr, memory->findings});
}

void AnalysedProgram::noteFlowFindings(Diagnostics found) const {
  const std::lock_guard lock(mutex);
  known = std::make_shared<const FlowMemory>(
      FlowMemory{shared, knownFlow, std::make_shared<const Diagnostics>(std::move(found))});
  if (flows) remembered.reset();
}

std::shared_ptr<const AnalysedProgram::Diagnostics> AnalysedProgram::flowFindings() const {
  flowFindingsOnce([this] {
    const auto now = flow();
    noteFlowFindings(now ? analysis::flow::checkFlow(now->flow(), analysis.index,
                                                     analysis::flow::wantsStyle(settings))
                         : Diagnostics());
  });
  const std::lock_guard lock(mutex);
  return known->findings;
}

std::shared_ptr<const KnownFlow> AnalysedProgram::flow() const {
  if (!flows) return nullptr;
  const std::lock_guard one(computing);
  if (auto now = flowIfKnown()) return now;
  auto computed = std::make_shared<const KnownFlow>(shared);
  const std::lock_guard lock(mutex);
  knownFlow = std::move(computed);
  if (known)
    known = std::make_shared<const FlowMemory>(FlowMemory{shared, knownFlow, known->findings});
  return knownFlow;
}

std::shared_ptr<const KnownFlow> AnalysedProgram::flowIfKnown() const {
  const std::lock_guard lock(mutex);
  return knownFlow;
}

std::shared_ptr<const AnalysedProgram> AnalysedProgram::beforeErrors() const {
  const std::lock_guard lock(mutex);
  return lastGood;
}

void AnalysedProgram::forgetFlow() const {
  const std::lock_guard lock(mutex);
  lastGood.reset();
  knownFlow.reset();
  known = withoutFlow(known);
  remembered = withoutFlow(remembered);
}

const std::vector<syntax::Diagnostic>& AnalysedProgram::findings() const {
  findingsOnce([this] {
    const auto& root = program.files.front();
    knownFindings = isFiacre(root.path)
                        ? analysis::flow::weighed(
                              readFiacre(root.path, root.document.text()).diagnostics, settings)
                        : analysis::flow::weighed(program, analysis, *flowFindings(), settings);
  });
  return knownFindings;
}

std::shared_ptr<const IncludeGraph> graphOf(const analysis::FileSystem& disk,
                                            const OpenTexts& open) {
  std::vector<IncludeGraph::File> files;
  for (const auto& [path, text] : open)
    files.push_back(std::make_shared<const KnownFile>(
        knownText(disk, path, disk.canonical(path).native(), text.document)));
  return std::make_shared<const IncludeGraph>(std::move(files));
}

Snapshot::Snapshot(std::shared_ptr<const analysis::FileSystem> disk, OpenTexts open,
                   std::shared_ptr<const IncludeGraph> graph, SettingsOf settings)
    : disk(std::move(disk)),
      texts(std::move(open)),
      graph(std::move(graph)),
      settings(std::move(settings)) {}

std::shared_ptr<const Snapshot> Snapshot::with(OpenTexts open,
                                               std::shared_ptr<const IncludeGraph> nowGraph) const {
  auto next = std::make_shared<Snapshot>(disk, std::move(open), std::move(nowGraph), settings);
  auto changed =
      graph == next->graph ? std::vector<std::string_view>() : graph->differenceTo(*next->graph);
  addOpened(changed, texts, next->texts);
  addOpened(changed, next->texts, texts);
  next->takeOpenPrograms(*this, changed);
  next->takeClosedPrograms(*this, changed);
  return next;
}

void Snapshot::takeOpenPrograms(const Snapshot& before,
                                const std::vector<std::string_view>& changed) {
  std::lock_guard lock(before.mutex);
  for (const auto& [root, entry] : before.entries) {
    const auto& last = entry->program ? entry->program : entry->earlier;
    if (!last) continue;
    if (entry->program && isCurrent(*last, before.texts, texts) && !hasOneOf(*last, changed))
      entries[root] = entry;
    else if (isOpen(*last, texts))
      entries.try_emplace(root, std::make_shared<Entry>()).first->second->earlier = last;
  }
}

/// Drops programs with a file that was opened, since its contents may have changed when it is
/// closed.
void Snapshot::takeClosedPrograms(const Snapshot& before,
                                  const std::vector<std::string_view>& changed) {
  if (changed.empty()) {
    closed = before.closed;
    return;
  }
  std::lock_guard lock(before.closed->mutex);
  for (const auto& item : before.closed->entries.all() | std::views::reverse)
    if (!hasOneOf(*item.value->program, changed)) closed->put(item.name, item.value);
}

void Snapshot::ClosedPrograms::put(const std::string& root, const std::shared_ptr<Entry>& entry) {
  std::size_t bytes = 0;
  for (const auto& file : entry->program->program.files) bytes += file.document.text().size();
  entries.put(root, entry, bytes);
}

/// The name under which a text is open, even if it was opened by another name of the same file.
fs::path Snapshot::nameOf(const fs::path& path) const {
  if (texts.contains(path)) return path;
  const auto* file = graph->find(disk->canonical(path).native());
  return file ? file->name : path;
}

std::expected<std::string, std::string> Snapshot::textOf(const fs::path& path) const {
  return Overlay(*disk, *this).read(path);
}

std::expected<syntax::Document, std::string> Snapshot::documentOf(const fs::path& path) const {
  return Overlay(*disk, *this).document(path);
}

std::vector<std::shared_ptr<const AnalysedProgram>> Snapshot::takeReplaced() const {
  const std::lock_guard lock(mutex);
  return std::exchange(replaced, {});
}

bool Snapshot::takeMissedFlow() const {
  const std::lock_guard lock(mutex);
  bool result = false;
  for (const auto& [root, entry] : entries)
    result |= entry->program && entry->program->takeMissedFlow();
  return result;
}

std::optional<View> Snapshot::viewIn(const fs::path& root, const fs::path& file) const {
  auto analysed = program(root);
  const auto id = fileIn(analysed->program, file);
  return id ? std::optional(View{std::move(analysed), *id}) : std::nullopt;
}

void Snapshot::eachView(const fs::path& file, const std::function<void(const View&)>& visit) const {
  bool any = false;
  for (const auto& root : rootsOf(file))
    if (const auto found = viewIn(root, file)) {
      any = true;
      visit(*found);
    }
  // the apparent includers do not include it, because of links or depth: it is its own root
  if (!any) visit({program(file), 0});
}

std::vector<fs::path> Snapshot::rootsOf(const fs::path& file) const {
  auto roots = graph->rootsOf(file);
  std::ranges::stable_partition(roots, [this](const auto& root) { return texts.contains(root); });
  return roots;
}

std::vector<View> Snapshot::views(const fs::path& file) const {
  std::vector<View> result;
  eachView(file, [&](const View& view) { result.push_back(view); });
  return result;
}

bool Snapshot::isLookedAt(const AnalysedProgram& analysed) const {
  lookedAtOnce([this] {
    for (const auto& [path, text] : texts) lookedAt.insert(rootsOf(path).front().native());
  });
  return lookedAt.contains(analysed.program.files.front().path.native());
}

/// Views the file in one program. There may be hundreds of others, which are ignored.
View Snapshot::view(const fs::path& file) const {
  for (const auto& root : rootsOf(file))
    if (auto found = viewIn(root, file)) return std::move(*found);
  return {program(file), 0};
}

std::shared_ptr<const AnalysedProgram> Snapshot::program(const fs::path& root) const {
  const auto entry = entryOf(root.native());
  entry->once([&] { analyse(entry, root); });
  return entry->program;
}

std::shared_ptr<Snapshot::Entry> Snapshot::entryOf(const std::string& root) const {
  std::lock_guard lock(mutex);
  if (const auto found = entries.find(root); found != entries.end()) return found->second;
  {
    std::lock_guard lockClosed(closed->mutex);
    if (const auto* found = closed->entries.use(root)) return *found;
  }
  return entries.emplace(root, std::make_shared<Entry>()).first->second;
}

/// The files of a program are known only after its analysis.
void Snapshot::analyse(const std::shared_ptr<Entry>& entry, const fs::path& root) const {
  std::shared_ptr<const AnalysedProgram> earlier;
  {
    std::lock_guard lock(mutex);
    earlier = entry->earlier;
  }
  auto whole = std::make_shared<const AnalysedProgram>(
      loaded(Overlay(*disk, *this), root), settings ? settings(root) : analysis::flow::Settings{},
      earlier);
  std::lock_guard lock(mutex);
  entry->program = std::move(whole);
  entry->earlier.reset();
  if (earlier) replaced.push_back(std::move(earlier));
  if (isOpen(*entry->program, texts)) return;
  entries.erase(root.native());
  std::lock_guard lockClosed(closed->mutex);
  closed->put(root.native(), entry);
}

} // namespace proskill::ide
