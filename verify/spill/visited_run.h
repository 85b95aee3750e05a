#pragma once

#include "verify/spill/state_group.h"

namespace proskill::verify {

/// States in their order, each with zones, in a file. An index in memory has some of the states, so
/// that parts of the file can be passed over.
class VisitedRun {
public:
  /// \pre the argument outlives this
  VisitedRun(SpillSpace& space, const SpillFormat& format);

  /// What a run has for a state. The zones are bytes, so that they can be copied.
  struct Entry {
    std::vector<Word> state;
    std::uint64_t zones = 1;
    bool areMerged = false; ///< see StateZones
    std::uint32_t dimension = 1;
    std::uint64_t bytes = 0; ///< of the zones
  };

  /// Adds a state, which is greater than those before. \throw LimitMet
  void add(const Entry& entry, std::string_view zones);
  [[nodiscard]] std::uint64_t size() const { return file.size(); } ///< in bytes on disk
  [[nodiscard]] std::uint64_t bytes() const {                      ///< of memory
    return file.bytes() + firsts.capacity() * sizeof(Word) +
           offsets.capacity() * sizeof(std::uint64_t);
  }

  /// A place in a run.
  class Cursor {
  public:
    /// Before the first state. \pre the run outlives this
    explicit Cursor(const VisitedRun& of);

    /// Moves to the next state. \return false at the end
    bool next();
    /// Moves to the first state from here on that is not smaller than a state.
    /// \pre the states of all calls ascend \return whether it is the same
    bool find(const Word* state);
    [[nodiscard]] const Entry& entry() const { return current; }
    [[nodiscard]] bool isAtEnd() const { return atEnd; }
    /// Appends the zones of the entry. Call this once at most.
    void readZones(StateGroup& to);
    /// The same as bytes.
    void readZones(std::string& to);

  private:
    void jumpTowards(const Word* state);
    void readEntry();

    const VisitedRun& run;
    PageReader reader;
    Entry current;
    std::uint64_t unread = 0; ///< bytes of the entry
    std::size_t block = 0;    ///< number of blocks that have been begun
    bool isBefore = true;     ///< the first state
    bool atEnd = false;
  };

private:
  SpillFormat format;
  std::size_t blockBytes;
  PagedFile file;
  std::vector<Word> firsts;           ///< by block: its first state
  std::vector<std::uint64_t> offsets; ///< by block: where it begins
  std::vector<Word> before;
};

} // namespace proskill::verify
