#include "ide/features/moved_files.h"

#include "ide/features/structure.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace proskill::ide {

namespace {

namespace fs = std::filesystem;

fs::path nameAfter(const fs::path& file, const std::vector<Move>& moves) {
  for (const auto& [from, to] : moves) {
    const auto [outer, inner] = std::ranges::mismatch(from, file);
    if (outer == from.end()) return std::accumulate(inner, file.end(), to, std::divides());
  }
  return file;
}

/// The file that moves when a text does: for a notebook cell, its notebook.
fs::path moverOf(const Snapshot& snapshot, const fs::path& file) {
  if (snapshot.kindOf(file) != TextKind::Cell) return file;
  const auto roots = snapshot.includes()->rootsOf(file);
  const auto found = std::ranges::find(roots, TextKind::Notebook,
                                       [&](const auto& root) { return snapshot.kindOf(root); });
  return found == roots.end() ? file : *found;
}

/// Whether it neither moves nor includes a file that does.
bool isUntouched(const KnownFile& file, const fs::path& mover, const std::vector<Move>& moves) {
  auto stays = [&](const fs::path& path) { return nameAfter(path, moves) == path; };
  return stays(mover) && std::ranges::all_of(file.includes, stays, &KnownFile::Include::path);
}

std::vector<syntax::TextEdit> editsOf(const fs::path& file, const fs::path& mover,
                                      const syntax::Document& document,
                                      const std::vector<Move>& moves) {
  std::vector<syntax::TextEdit> edits;
  const auto folder = nameAfter(mover, moves).parent_path();
  for (const auto& [range, target] : links(file, document)) {
    const fs::path written = document.text().substr(range.begin, range.length());
    const auto now = nameAfter(target, moves);
    if ((folder / written).lexically_normal() == now) continue;
    const auto text = written.is_absolute() ? now : now.lexically_relative(folder);
    edits.push_back({range, text.generic_string()});
  }
  return edits;
}

} // namespace

std::map<fs::path, std::vector<syntax::TextEdit>> includesAfter(const Snapshot& snapshot,
                                                                const std::vector<Move>& moves) {
  std::map<fs::path, std::vector<syntax::TextEdit>> result;
  for (const auto& file : snapshot.knownFiles()) {
    const auto mover = moverOf(snapshot, file->name);
    if (isUntouched(*file, mover, moves) || snapshot.kindOf(file->name) == TextKind::Notebook)
      continue;
    auto edits = editsOf(file->name, mover, snapshot.view(file->name).document(), moves);
    if (!edits.empty()) result.emplace(file->name, std::move(edits));
  }
  return result;
}

} // namespace proskill::ide
