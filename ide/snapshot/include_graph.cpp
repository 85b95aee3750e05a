#include "ide/snapshot/include_graph.h"

#include "ide/snapshot/fiacre_file.h"

#include <algorithm>
#include <ranges>
#include <set>

namespace proskill::ide {

namespace fs = std::filesystem;

namespace {

constexpr auto kCanonical = [](const IncludeGraph::File& file) -> std::string_view {
  return file->canonical;
};

/// The paths that a document includes. If the document has two names in different directories, they
/// may be relative to either.
std::vector<std::string> pathsFrom(const KnownFile& file, const syntax::Document& document) {
  std::vector<std::string> result;
  auto add = [&](const fs::path& from) {
    for (const auto& path : includesOf(from, document)) result.push_back(path.native());
  };
  add(file.name);
  if (file.name.native() != file.canonical) add(file.canonical);
  return result;
}

} // namespace

std::vector<fs::path> includesOf(const fs::path& file, const syntax::Document& document) {
  std::vector<fs::path> result;
  if (isFiacre(file)) return result;
  for (const auto& form : document.forms())
    if (const auto* include = form.as<syntax::Include>(); include && include->path)
      result.push_back((file.parent_path() / include->path.text).lexically_normal());
  return result;
}

KnownFile knownText(const analysis::FileSystem& files, fs::path name, std::string canonical,
                    const syntax::Document& document) {
  KnownFile result{std::move(name), std::move(canonical), {}};
  for (auto& path : pathsFrom(result, document)) {
    auto found = files.canonical(path).native();
    result.includes.push_back({std::move(path), std::move(found)});
  }
  return result;
}

KnownFile knownFile(const analysis::FileSystem& files, fs::path name, std::string canonical,
                    const syntax::Document& document) {
  auto result = knownText(files, std::move(name), std::move(canonical), document);
  if (!isFiacre(result.name)) result.names = FileNames(document);
  return result;
}

bool includesAsBefore(const KnownFile& file, const syntax::Document& document) {
  return std::ranges::equal(pathsFrom(file, document), file.includes, {}, {},
                            &KnownFile::Include::path);
}

IncludeGraph::IncludeGraph(std::vector<File> files) : all(std::move(files)) {
  std::ranges::stable_sort(all, {}, kCanonical);
  // backwards, so that the last of equal elements is kept
  const auto kept = std::ranges::unique(all | std::views::reverse, {}, kCanonical);
  all.erase(all.begin(), kept.begin().base());
}

std::shared_ptr<const IncludeGraph> IncludeGraph::with(KnownFile file) const {
  auto files = all;
  auto place = std::ranges::lower_bound(files, std::string_view(file.canonical), {}, kCanonical);
  const bool isKnown = place != files.end() && (*place)->canonical == file.canonical;
  auto fresh = std::make_shared<const KnownFile>(std::move(file));
  if (isKnown)
    *place = std::move(fresh);
  else
    files.insert(place, std::move(fresh));
  return std::make_shared<const IncludeGraph>(std::move(files));
}

std::shared_ptr<const IncludeGraph> IncludeGraph::without(std::string_view canonical) const {
  auto files = all;
  std::erase_if(files, [&](const File& file) { return file->canonical == canonical; });
  return std::make_shared<const IncludeGraph>(std::move(files));
}

/// The lists share most files, and are sorted.
std::vector<std::string_view> IncludeGraph::differenceTo(const IncludeGraph& other) const {
  std::vector<std::string_view> result;
  auto one = all.begin();
  auto two = other.all.begin();
  while (one != all.end() || two != other.all.end()) {
    const bool hasBoth = one != all.end() && two != other.all.end();
    if (hasBoth && *one == *two) {
      ++one;
      ++two;
      continue;
    }
    const bool isFirst =
        two == other.all.end() || (hasBoth && kCanonical(*one) <= kCanonical(*two));
    const bool isSecond = one == all.end() || (hasBoth && kCanonical(*two) <= kCanonical(*one));
    result.push_back(isFirst ? kCanonical(*one) : kCanonical(*two));
    if (isFirst) ++one;
    if (isSecond) ++two;
  }
  return result;
}

const KnownFile* IncludeGraph::find(std::string_view canonical) const {
  const auto found = std::ranges::lower_bound(all, canonical, {}, kCanonical);
  return found != all.end() && (*found)->canonical == canonical ? found->get() : nullptr;
}

const KnownFile* IncludeGraph::named(const Path& name) const {
  const auto found = edges().byName.find(name.native());
  return found == edges().byName.end() ? nullptr : all[found->second].get();
}

const IncludeGraph::Edges& IncludeGraph::edges() const {
  once([this] {
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      known.byName.emplace(all[i]->name.native(), i);
      for (const auto& include : all[i]->includes) {
        auto& includers = known.includers[include.canonical];
        if (includers.empty() || includers.back() != i) includers.push_back(i);
      }
    }
  });
  return known;
}

std::string_view IncludeGraph::canonicalOf(const Path& name) const {
  const auto* file = named(name);
  return file ? std::string_view(file->canonical) : std::string_view(name.native());
}

/// Follows includers upwards. Files that include each other in a cycle are roots themselves.
std::vector<fs::path> IncludeGraph::rootsOf(const Path& file) const {
  const auto& includers = edges().includers;
  std::vector<Path> roots;
  std::vector<std::string_view> pending{canonicalOf(file)};
  std::set<std::string_view> seen{pending.front()};
  while (!pending.empty()) {
    const auto current = pending.back();
    pending.pop_back();
    const auto found = includers.find(current);
    if (found == includers.end()) {
      const auto* root = find(current);
      roots.push_back(root ? root->name : file);
      continue;
    }
    for (auto i : found->second)
      if (seen.insert(all[i]->canonical).second) pending.push_back(all[i]->canonical);
  }
  if (roots.empty()) roots.push_back(file);
  std::ranges::sort(roots);
  return roots;
}

std::vector<fs::path> IncludeGraph::roots() const {
  std::vector<Path> result;
  std::set<const KnownFile*> reached;
  auto begin = [&](const KnownFile& root) {
    result.push_back(root.name);
    std::vector<const KnownFile*> pending{&root};
    while (!pending.empty()) {
      const auto* current = pending.back();
      pending.pop_back();
      if (!reached.insert(current).second) continue;
      for (const auto& include : current->includes)
        if (const auto* target = find(include.canonical)) pending.push_back(target);
    }
  };
  for (const auto& file : all)
    if (!edges().includers.contains(file->canonical)) begin(*file);
  for (const auto& file : all) // files that include each other in a cycle
    if (!reached.contains(file.get())) begin(*file);
  return result;
}

} // namespace proskill::ide
