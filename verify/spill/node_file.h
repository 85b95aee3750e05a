#pragma once

#include "verify/spill/state_group.h"

namespace proskill::verify {

/// A node of a search on disk.
struct SpilledNode {
  std::vector<Word> state; ///< its stored words
  Dbm zone;
  std::uint64_t parent = 0; ///< see Discovery
  TransitionId step = kNone;
};

/// The nodes of a search in the order in which they were reached, from 0.
class NodeFile {
public:
  /// \pre the argument outlives this
  NodeFile(SpillSpace& space, const SpillFormat& format);

  /// The bytes of a node that is not in the file yet.
  [[nodiscard]] std::string_view textOf(const StateGroup& group, std::size_t zone);
  /// Adds a node. \throw LimitMet
  void add(std::string_view text);
  [[nodiscard]] std::uint64_t size() const { return count; }
  [[nodiscard]] SpilledNode at(std::uint64_t node) const;
  [[nodiscard]] std::uint64_t bytes() const {
    return file.bytes() + offsets.capacity() * sizeof(std::uint64_t);
  }

  /// Reads the nodes from one on. Nodes may be added meanwhile.
  class Reader {
  public:
    /// \pre the file outlives this
    Reader(const NodeFile& of, std::uint64_t first);
    /// The next node. \pre there is one \throw LimitMet
    void next(SpilledNode& to);

  private:
    const NodeFile& nodes;
    PageReader reader;
    std::uint64_t number; ///< of the next node
    std::vector<Word> state;
    std::vector<Bound> bounds;
  };

private:
  static constexpr std::uint64_t kNodesOfBlock = 256;

  SpillFormat format;
  PagedFile file;
  std::vector<std::uint64_t> offsets; ///< by block
  std::uint64_t count = 0;
  std::vector<Word> before;
  std::vector<Word> added;
  ByteText text;
};

} // namespace proskill::verify
