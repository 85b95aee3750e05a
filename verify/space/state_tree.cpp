#include "verify/space/state_tree.h"

#include <array>
#include <bit>

namespace proskill::verify {

namespace {

/// Number of bits of the first word that states use.
std::uint32_t bitsOfFirstWord(const System& system) {
  Word used = 0;
  for (const auto& cell : system.cells)
    if (cell.word == 0) used |= cell.mask;
  return static_cast<std::uint32_t>(std::bit_width(used));
}

} // namespace

std::uint32_t StateTree::Numbers::add(std::uint64_t key) {
  const auto next = static_cast<std::uint32_t>(keys.size());
  const auto id =
      table.findOrAdd(hash(key), next, [&](std::uint32_t other) { return keys[other] == key; });
  if (id == next) keys.push_back(key);
  return id;
}

std::uint32_t StateTree::Numbers::find(std::uint64_t key) const {
  return table.find(hash(key), [&](std::uint32_t other) { return keys[other] == key; });
}

StateTree::StateTree(std::uint32_t wordsOfEach, std::uint32_t firstBits)
    : words(wordsOfEach), half((firstBits + 1) / 2), leaves(std::max(2U, wordsOfEach)) {
  std::vector<std::uint32_t> row(leaves);
  for (std::uint32_t i = 0; i < leaves; ++i) row[i] = i;
  while (row.size() > 2) {
    std::vector<std::uint32_t> above;
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
      above.push_back(leaves + static_cast<std::uint32_t>(joins.size()));
      joins.push_back({row[i], row[i + 1]});
    }
    if (row.size() % 2 != 0) above.push_back(row.back());
    row = std::move(above);
  }
  joins.push_back({row[0], row[1]}); // the root
  nodes.resize(leaves + joins.size() - 1);
  last = nowhere();
}

StateTree::StateTree(const System& system)
    : StateTree(system.storedWords, bitsOfFirstWord(system)) {}

std::uint64_t StateTree::leaf(const Word* state, std::uint32_t i) const {
  if (words != 1) return state[i];
  return i == 0 ? state[0] & ((Word{1} << half) - 1) : state[0] >> half;
}

/// Finds the numbers of all nodes below the root. `number` returns that of a key in a table, or
/// kNone.
template <class Number>
std::optional<SoughtRoot> StateTree::walk(const Word* state, Path& path, Number number) const {
  const auto visit = [&](std::size_t node, std::uint64_t key) {
    if (path.ids[node] != kNone && path.keys[node] == key) return true;
    path.keys[node] = key;
    path.ids[node] = number(node, key);
    return path.ids[node] != kNone;
  };
  for (std::uint32_t i = 0; i < leaves; ++i)
    if (!visit(i, leaf(state, i))) return std::nullopt;
  for (std::size_t i = 0; i + 1 < joins.size(); ++i)
    if (!visit(leaves + i, std::uint64_t{path.ids[joins[i].left]} << 32 | path.ids[joins[i].right]))
      return std::nullopt;
  return SoughtRoot({path.ids[joins.back().left], path.ids[joins.back().right]});
}

SoughtRoot StateTree::rootOf(const Word* state) {
  return walk(state, last,
              [&](std::size_t node, std::uint64_t key) { return nodes[node].add(key); })
      .value_or(SoughtRoot{});
}

std::optional<SoughtRoot> StateTree::findRoot(const Word* state, Path& path) const {
  if (path.ids.empty()) path = nowhere();
  return walk(state, path,
              [&](std::size_t node, std::uint64_t key) { return nodes[node].find(key); });
}

const std::vector<std::optional<SoughtRoot>>& StateTree::findRoots(std::span<const Word> states,
                                                                   std::size_t stride,
                                                                   const Path& near,
                                                                   Group& group) const {
  const std::size_t count = states.size() / stride;
  group.keys.resize(count);
  group.ids.resize(count * nodes.size());
  const auto idsOf = [&](std::uint32_t node) { return &group.ids[node * count]; };
  for (std::uint32_t i = 0; i < leaves; ++i) {
    for (std::size_t k = 0; k < count; ++k) group.keys[k] = leaf(&states[k * stride], i);
    findNodes(i, near, group);
  }
  for (std::size_t i = 0; i + 1 < joins.size(); ++i) {
    const std::uint32_t* left = idsOf(joins[i].left);
    const std::uint32_t* right = idsOf(joins[i].right);
    for (std::size_t k = 0; k < count; ++k) group.keys[k] = std::uint64_t{left[k]} << 32 | right[k];
    findNodes(leaves + i, near, group);
  }
  group.roots.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Root root{idsOf(joins.back().left)[k], idsOf(joins.back().right)[k]};
    const bool isKnown = root.left != kNone && root.right != kNone;
    group.roots[k] = isKnown ? std::optional(SoughtRoot(root)) : std::nullopt;
  }
  return group.roots;
}

/// Finds the number of a node of all states of the group; kNone where it has none, as then no node
/// above it has one. The processor loads what it needs for one while it looks at others.
void StateTree::findNodes(std::size_t node, const Path& near, Group& group) const {
  std::uint32_t* ids = &group.ids[node * group.keys.size()];
  group.other.clear();
  for (std::uint32_t k = 0; k < group.keys.size(); ++k) {
    ids[k] = near.ids[node];
    if (group.keys[k] == near.keys[node]) continue;
    nodes[node].prefetch(group.keys[k]);
    group.other.push_back(k);
  }
  for (auto k : group.other) nodes[node].prefetchKey(group.keys[k]);
  for (auto k : group.other) ids[k] = nodes[node].find(group.keys[k]);
}

void StateTree::read(StateId id, Word* state) const {
  constexpr std::size_t kFew = 64;
  std::array<std::uint32_t, kFew> few{};
  std::vector<std::uint32_t> many(nodes.size() > kFew ? nodes.size() : 0);
  std::uint32_t* numbers = many.empty() ? few.data() : many.data();
  readNodes(id, numbers);
  readWords(numbers, state);
}

void StateTree::read(StateId id, Word* state, Path& path) const {
  path.keys.resize(nodes.size());
  path.ids.resize(nodes.size());
  readNodes(id, path.ids.data());
  readWords(path.ids.data(), state);
  for (std::size_t i = 0; i < nodes.size(); ++i) path.keys[i] = nodes[i].keys[path.ids[i]];
}

/// Finds the numbers of all nodes below the root.
void StateTree::readNodes(StateId id, std::uint32_t* numbers) const {
  const Root root = roots.at(id);
  numbers[joins.back().left] = root.left;
  numbers[joins.back().right] = root.right;
  for (std::size_t i = joins.size() - 1; i-- > 0;) {
    const std::uint64_t key = nodes[leaves + i].keys[numbers[leaves + i]];
    numbers[joins[i].left] = static_cast<std::uint32_t>(key >> 32);
    numbers[joins[i].right] = static_cast<std::uint32_t>(key);
  }
}

void StateTree::readWords(const std::uint32_t* numbers, Word* state) const {
  if (words == 1) {
    state[0] = nodes[0].keys[numbers[0]] | nodes[1].keys[numbers[1]] << half;
    return;
  }
  for (std::uint32_t i = 0; i < words; ++i) state[i] = nodes[i].keys[numbers[i]];
}

std::uint64_t StateTree::bytes() const {
  std::uint64_t all = roots.bytes();
  for (const auto& of : nodes) all += of.table.bytes() + of.keys.capacity() * sizeof(std::uint64_t);
  return all;
}

std::uint64_t StateTree::growth() const {
  std::uint64_t all = roots.growth();
  for (const auto& of : nodes) all += of.table.growth() + growthOf(of.keys);
  return all;
}

} // namespace proskill::verify
