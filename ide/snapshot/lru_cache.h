#pragma once

#include <cstddef>
#include <iterator>
#include <list>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace proskill::ide {

/// A least-recently-used cache of values that can be computed again. Not thread-safe.
template <class Value> class LruCache {
public:
  struct Item {
    std::string name;
    std::size_t size = 0;
    Value value;
  };

  explicit LruCache(std::size_t room) : room(room) {}
  LruCache(const LruCache&) = delete; ///< names refer to the items' own strings
  LruCache& operator=(const LruCache&) = delete;

  /// Null if it is not cached. Marks it as used; valid until the next `put`.
  [[nodiscard]] Value* use(std::string_view name) {
    const auto found = byName.find(name);
    if (found == byName.end()) return nullptr;
    items.splice(items.begin(), items, found->second);
    return &items.front().value;
  }
  /// Adds or replaces an item. An item larger than the capacity is then the only one.
  void put(std::string name, Value value, std::size_t size) {
    drop(name);
    items.push_front({std::move(name), size, std::move(value)});
    byName.emplace(items.front().name, items.begin());
    used += size;
    while (used > room && items.size() > 1) drop(std::string_view(items.back().name));
  }
  void drop(std::string_view name) {
    const auto found = byName.find(name);
    if (found == byName.end()) return;
    const auto item = found->second;
    used -= item->size;
    byName.erase(found);
    items.erase(item);
  }

  /// The most recently used first.
  [[nodiscard]] const std::list<Item>& all() const { return items; }

private:
  std::size_t room;
  std::size_t used = 0;
  std::list<Item> items;
  std::unordered_map<std::string_view, typename std::list<Item>::iterator> byName;
};

} // namespace proskill::ide
