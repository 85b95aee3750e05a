#pragma once

#include "verify/spill/candidate_table.h"

#include <optional>

namespace proskill::verify {

/// The candidates of a level: states with zones that may be new. They are collected in a table; a
/// full table is sorted and written as a *run*, and at the end the runs are merged.
class CandidateRuns {
public:
  /// \pre `zones` has the zones that are added, until a run is written; it outlives this, as
  /// `space`
  CandidateRuns(SpillSpace& space, const SpillFormat& format, const ZoneStore& zones);

  void add(const Word* state, ZoneId zone, const Discovery& how) {
    table.add(state, zone, how);
    if (table.isFull()) writeRun();
  }
  /// Writes what the table has, so that zones may get other numbers. \throw LimitMet
  void writeRun();
  /// The next state with its zones, each once. Call writeRun() before the first.
  /// \return false at the end, when all have been removed \throw LimitMet
  bool next(StateGroup& to);
  /// Gives memory back when no more candidates follow.
  void release() { table.release(); }
  [[nodiscard]] std::uint64_t bytes() const { return table.bytes() + file->bytes(); }

private:
  struct Run {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
  };
  /// The next state of a run, and how many zones it has.
  struct Cursor {
    PageReader reader;
    std::vector<Word> state;
    std::uint64_t zones = 0; ///< 0: at the end
    std::uint32_t dimension = 1;
  };

  void open();
  void advance(Cursor& cursor) const;
  void readZones(Cursor& cursor, StateGroup& to) const;
  bool nextOfAll(StateGroup& to);
  void removeDoubles(StateGroup& group);
  void write(PagedFile& to, std::vector<Word>& before, const StateGroup& group) const;
  void writeDiscovery(PagedFile& to, const Discovery& how) const;
  void mergeRuns();

  SpillSpace& space;
  SpillFormat format;
  const ZoneStore& store;
  CandidateTable table;
  std::unique_ptr<PagedFile> file;
  std::vector<Run> runs;
  std::vector<Cursor> cursors; ///< empty: not open yet
  StateGroup sorted;
  std::vector<std::uint32_t> order; ///< of the zones of a group
};

} // namespace proskill::verify
