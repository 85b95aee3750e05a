#include "ide/snapshot.h"

#include "analysis/reuse.h"
#include "ide/fiacre_file.h"

#include <algorithm>
#include <optional>
#include <set>

namespace proskill::ide {

namespace {

namespace fs = std::filesystem;

/// The disk, with what the editor holds in front of it.
class Overlay : public analysis::FileSystem {
public:
  Overlay(const analysis::FileSystem& disk, const OpenTexts& open) : disk(disk), open(open) {}

  [[nodiscard]] std::expected<std::string, std::string> read(const fs::path& path) const override {
    auto found = open.find(path);
    return found == open.end() ? disk.read(path) : found->second.document.text();
  }
  [[nodiscard]] fs::path canonical(const fs::path& path) const override {
    return disk.canonical(path);
  }
  [[nodiscard]] std::expected<syntax::Document, std::string>
  document(const fs::path& path) const override {
    auto found = open.find(path);
    return found == open.end() ? disk.document(path) : found->second.document;
  }

private:
  const analysis::FileSystem& disk;
  const OpenTexts& open;
};

std::optional<analysis::FileId> fileIn(const analysis::Program& program, const fs::path& path) {
  auto found = std::ranges::find(program.files, path, &analysis::File::path);
  if (found == program.files.end()) return std::nullopt;
  return static_cast<analysis::FileId>(found - program.files.begin());
}

/// Whether the program was made from just these texts, where they are open, and from no others.
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

/// Of a model in Fiacre, which defines nothing, the text alone.
analysis::Program loaded(const Overlay& files, const fs::path& root) {
  if (!isFiacre(root)) return analysis::load(files, root);
  return readFiacre(root, files.read(root).value_or(std::string())).program;
}

} // namespace

AnalysedProgram::AnalysedProgram(analysis::Program loaded, analysis::flow::Settings settings,
                                 const AnalysedProgram* earlier)
    : shared(std::make_shared<const analysis::Program>(std::move(loaded))),
      program(*shared),
      analysis(earlier ? analysis::analyse(program, {earlier->program, earlier->analysis})
                       : analysis::analyse(program)),
      settings(std::move(settings)) {
  if (earlier) takeFlow(*earlier);
}

/// White space and comments do not change what flows where.
void AnalysedProgram::takeFlow(const AnalysedProgram& earlier) {
  remembered = earlier.memory();
  if (!remembered || !analysis::flow::hasFlow(program, analysis)) return;
  const auto edit = analysis::changeBetween(*remembered->program, program);
  auto moved = edit ? analysis::movedByLayout(remembered->findings, *edit) : std::nullopt;
  auto flow = moved ? remembered->flow->after(edit->file, *edit->change.layout) : nullptr;
  if (!flow) return;
  std::call_once(flowOnce, [&] {
    knownFlow = std::move(flow);
    readyFlow = knownFlow.get();
  });
  std::call_once(flowFindingsOnce, [&] { noteFlowFindings(std::move(*moved)); });
  remembered.reset();
}

/// Of this program where it is known, else of the last one before it.
std::shared_ptr<const AnalysedProgram::FlowMemory> AnalysedProgram::memory() const {
  return knowsFlowFindings && knownFlow ? knownFlowFindings : remembered;
}

void AnalysedProgram::noteFlowFindings(std::vector<syntax::Diagnostic> found) const {
  knownFlowFindings =
      std::make_shared<const FlowMemory>(FlowMemory{shared, knownFlow, std::move(found)});
  knowsFlowFindings = true;
}

const std::vector<syntax::Diagnostic>& AnalysedProgram::flowFindings() const {
  std::call_once(flowFindingsOnce, [this] {
    const auto* known = flow();
    noteFlowFindings(known ? analysis::flow::checkFlow(known->flow(), analysis.index,
                                                       analysis::flow::wantsStyle(settings))
                           : std::vector<syntax::Diagnostic>());
  });
  return knownFlowFindings->findings;
}

const KnownFlow* AnalysedProgram::flow() const {
  std::call_once(flowOnce, [this] {
    if (analysis::flow::hasFlow(program, analysis))
      knownFlow = std::make_shared<const KnownFlow>(shared);
    readyFlow = knownFlow.get();
  });
  return knownFlow.get();
}

const std::vector<syntax::Diagnostic>& AnalysedProgram::findings() const {
  std::call_once(findingsOnce, [this] {
    const auto& root = program.files.front();
    knownFindings = isFiacre(root.path)
                        ? readFiacre(root.path, root.document.text()).diagnostics
                        : analysis::flow::weighed(program, analysis, flowFindings(), settings);
  });
  return knownFindings;
}

Snapshot::Snapshot(std::shared_ptr<const analysis::FileSystem> disk, OpenTexts open,
                   Includes includes, SettingsOf settings)
    : disk(std::move(disk)),
      texts(std::move(open)),
      includes(std::move(includes)),
      settings(std::move(settings)) {}

std::shared_ptr<const Snapshot> Snapshot::with(OpenTexts open, Includes nowIncludes) const {
  auto next = std::make_shared<Snapshot>(disk, std::move(open), std::move(nowIncludes), settings);
  std::lock_guard lock(mutex);
  for (const auto& [root, entry] : entries) {
    const auto& last = entry->program ? entry->program : entry->earlier;
    if (!last) continue;
    if (entry->program && isCurrent(*last, texts, next->texts))
      next->entries[root] = entry;
    else if (isOpen(*last, next->texts))
      next->entries.try_emplace(root, std::make_shared<Entry>()).first->second->earlier = last;
  }
  return next;
}

std::vector<std::shared_ptr<const AnalysedProgram>> Snapshot::takeReplaced() const {
  const std::lock_guard lock(mutex);
  return std::exchange(replaced, {});
}

std::vector<fs::path> Snapshot::roots() const {
  std::set<fs::path> included;
  for (const auto& [includer, targets] : includes) included.insert(targets.begin(), targets.end());
  std::vector<fs::path> result;
  std::set<fs::path> reached;
  auto begin = [&](const fs::path& root) {
    result.push_back(root);
    std::vector<fs::path> pending{root};
    while (!pending.empty()) {
      auto current = std::move(pending.back());
      pending.pop_back();
      if (!reached.insert(current).second) continue;
      if (auto found = includes.find(current); found != includes.end())
        pending.insert(pending.end(), found->second.begin(), found->second.end());
    }
  };
  for (const auto& file : files())
    if (!included.contains(file)) begin(file);
  for (const auto& file : files()) // those that include each other in a circle
    if (!reached.contains(file)) begin(file);
  return result;
}

std::vector<View> Snapshot::views(const fs::path& file) const {
  std::vector<View> result;
  for (const auto& root : rootsOf(file)) {
    auto analysed = program(root);
    if (auto id = fileIn(analysed->program, file)) result.push_back({analysed, *id});
  }
  // Who seems to include it does not, through links or too deep: it stands for itself.
  if (result.empty()) result.push_back({program(file), 0});
  return result;
}

View Snapshot::view(const fs::path& file) const { return views(file).front(); }

std::shared_ptr<const AnalysedProgram> Snapshot::program(const fs::path& root) const {
  std::shared_ptr<Entry> entry;
  std::shared_ptr<const AnalysedProgram> earlier;
  {
    std::lock_guard lock(mutex);
    auto& slot = entries[root];
    if (!slot) slot = std::make_shared<Entry>();
    entry = slot;
    earlier = entry->earlier;
  }
  std::call_once(entry->once, [&] {
    auto whole = std::make_shared<const AnalysedProgram>(
        loaded(Overlay(*disk, texts), root), settings ? settings(root) : analysis::flow::Settings{},
        earlier.get());
    std::lock_guard lock(mutex);
    entry->program = std::move(whole);
    entry->earlier.reset();
    if (earlier) replaced.push_back(std::move(earlier));
  });
  return entry->program;
}

/// Goes from includer to includer. Files that include each other in a circle have no root but
/// themselves.
std::vector<fs::path> Snapshot::rootsOf(const fs::path& file) const {
  std::vector<fs::path> roots;
  std::set<fs::path> seen{file};
  std::vector<fs::path> pending{file};
  while (!pending.empty()) {
    auto current = pending.back();
    pending.pop_back();
    bool included = false;
    for (const auto& [includer, targets] : includes) {
      // As text: all are normal, and a comparison part by part takes a hundred times as long.
      if (std::ranges::find(targets, current.native(), &fs::path::native) == targets.end())
        continue;
      included = true;
      if (seen.insert(includer).second) pending.push_back(includer);
    }
    if (!included) roots.push_back(current);
  }
  if (roots.empty()) roots.push_back(file);
  std::ranges::sort(roots);
  return roots;
}

std::vector<fs::path> includesOf(const fs::path& file, const syntax::Document& document) {
  std::vector<fs::path> result;
  if (isFiacre(file)) return result;
  for (const auto& form : document.forms())
    if (const auto* include = std::get_if<syntax::Include>(&form.node); include && include->path)
      result.push_back((file.parent_path() / include->path.text).lexically_normal());
  return result;
}

} // namespace proskill::ide
