#pragma once

#include "syntax/tree/tree.h"

#include <algorithm>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

/// Answers about whole texts are assembled from parts, one per region (`syntax::Region`). Parts
/// that an edit did not change are reused from the last answer.
namespace proskill::lsp {

/// LRU cache of the last answer for each of a few texts. Thread-safe.
template <class Value> class LastOfTexts {
public:
  /// Null if there is none.
  [[nodiscard]] std::shared_ptr<const Value> find(const std::string& uri) const {
    const std::lock_guard lock(mutex);
    const auto found = std::ranges::find(entries, uri, &Entry::uri);
    return found == entries.end() ? nullptr : found->value;
  }

  void keep(const std::string& uri, std::shared_ptr<const Value> value) {
    const std::lock_guard lock(mutex);
    entries.remove_if([&](const Entry& entry) { return entry.uri == uri; });
    if (entries.size() >= kMost) entries.pop_back();
    entries.push_front({uri, std::move(value)});
  }

private:
  struct Entry {
    std::string uri;
    std::shared_ptr<const Value> value;
  };
  static constexpr std::size_t kMost = 32;

  mutable std::mutex mutex;
  std::list<Entry> entries; ///< the most recent first
};

template <class Part> using Parts = std::vector<std::shared_ptr<const Part>>;

/// Finds the parts of an earlier answer by the trees of their regions. Call it in the order of the
/// text.
template <class Part> class EarlierParts {
public:
  explicit EarlierParts(Parts<Part> parts) : parts(std::move(parts)) {
    for (std::size_t i = 0; i < this->parts.size(); ++i) places[this->parts[i]->tree.get()] = i;
  }

  /// Null if the region is new, or if the order of the regions has changed.
  [[nodiscard]] std::shared_ptr<const Part> find(const std::shared_ptr<const syntax::Tree>& tree) {
    const auto found = places.find(tree.get());
    if (found == places.end() || found->second < next) return nullptr;
    next = found->second + 1;
    return parts[found->second];
  }

private:
  const Parts<Part> parts;
  std::unordered_map<const syntax::Tree*, std::size_t> places;
  std::size_t next = 0; ///< earlier parts have been passed
};

} // namespace proskill::lsp
