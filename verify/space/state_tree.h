#pragma once

#include "verify/space/root_table.h"
#include "verify/state/store.h"

#include <optional>
#include <span>
#include <vector>

namespace proskill::verify {

/// Discrete states, each stored once and in few bytes. A state is a tree: its words are numbered,
/// then the pairs of these numbers, and so on. States that differ little share all but a few nodes.
/// Laarman, van de Pol, Weber, "Parallel recursive state compression for free", SPIN 2011.
class StateTree {
public:
  /// The nodes of the last state that was looked up. States that are looked up one after the other
  /// are mostly similar.
  struct Path {
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> ids;
  };

  /// \param words of each state
  /// \param firstBits used bits of a state that has one word only
  StateTree(std::uint32_t words, std::uint32_t firstBits);
  /// For the stored words of the states of a system.
  explicit StateTree(const System& system);

  /// A path before any state was looked up.
  [[nodiscard]] Path nowhere() const {
    return {std::vector<std::uint64_t>(nodes.size()),
            std::vector<std::uint32_t>(nodes.size(), kNone)};
  }
  /// The root of a state, whose other nodes are added.
  [[nodiscard]] SoughtRoot rootOf(const Word* state);
  /// The same without adding anything; nothing if the state is certainly not stored. Several
  /// threads may call this at once, with paths of their own.
  [[nodiscard]] std::optional<SoughtRoot> findRoot(const Word* state, Path& path) const;
  /// Room for looking up states together.
  struct Group {
    std::vector<std::uint32_t> ids;   ///< by node, then by state
    std::vector<std::uint64_t> keys;  ///< by state: of the node that is looked up
    std::vector<std::uint32_t> other; ///< states that differ in it
    std::vector<std::optional<SoughtRoot>> roots;
  };
  /// What findRoot() returns for states that differ little from another one, faster than one by
  /// one. Several threads may call this at once, with groups of their own.
  /// \param states one after the other, all their words
  /// \param stride words of each
  /// \param near the nodes of the other one, as read() returns them
  /// \return `group.roots`
  const std::vector<std::optional<SoughtRoot>>&
  findRoots(std::span<const Word> states, std::size_t stride, const Path& near, Group& group) const;
  using Added = RootTable::Added;
  Added add(const Word* state) { return roots.add(rootOf(state)); }
  /// The number of a state; kNone if it is not stored. Several threads may call this at once.
  [[nodiscard]] StateId find(const SoughtRoot& root) const { return roots.find(root); }

  void read(StateId id, Word* state) const;
  void read(StateId id, Word* state, Path& nodes) const;
  [[nodiscard]] std::uint32_t size() const { return roots.size(); }
  [[nodiscard]] std::uint64_t bytes() const;
  /// Bytes that the next few steps may allocate at once.
  [[nodiscard]] std::uint64_t growth() const;

  RootTable roots;

private:
  /// A node that is not the root: where its children are in a Path, and its table.
  struct Join {
    std::uint32_t left = 0;
    std::uint32_t right = 0;
  };
  /// Numbers for words, or for pairs of numbers.
  struct Numbers {
    LargeVector<std::uint64_t> keys;
    NumberTable table;

    [[nodiscard]] static std::uint64_t hash(std::uint64_t key) {
      return mix(mix(0, key), key >> 32);
    }
    std::uint32_t add(std::uint64_t key);
    void prefetch(std::uint64_t key) const { table.prefetch(hash(key)); }
    /// The same with what find() looks at after that.
    void prefetchKey(std::uint64_t key) const {
      const std::uint32_t id = table.guess(hash(key));
      if (id != kNone) __builtin_prefetch(&keys[id]);
    }
    [[nodiscard]] std::uint32_t find(std::uint64_t key) const;
  };

  template <class Number>
  std::optional<SoughtRoot> walk(const Word* state, Path& path, Number number) const;
  [[nodiscard]] std::uint64_t leaf(const Word* state, std::uint32_t i) const;
  void findNodes(std::size_t node, const Path& near, Group& group) const;
  void readNodes(StateId id, std::uint32_t* numbers) const;
  void readWords(const std::uint32_t* numbers, Word* state) const;

  std::uint32_t words;
  std::uint32_t half; ///< bits of the left part of a state that has one word only
  std::uint32_t leaves;
  std::vector<Join> joins;
  std::vector<Numbers> nodes; ///< of leaves, then of joins
  Path last;
};

} // namespace proskill::verify
