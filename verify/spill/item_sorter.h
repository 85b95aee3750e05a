#pragma once

#include "verify/model/release.h"
#include "verify/spill/paged_file.h"

#include <functional>

namespace proskill::verify {

/// Sorts texts by numbers, and those with the same number by their bytes; each is there once. What
/// does not fit into memory is on disk.
class ItemSorter {
public:
  /// \pre `space` outlives this \param bytes of memory
  ItemSorter(SpillSpace& space, std::uint64_t bytes);

  void add(std::uint64_t number, std::string_view text);
  using Visit = std::function<void(std::string_view)>;
  /// Visits and removes all. \throw LimitMet
  void each(const Visit& visit);
  /// Gives memory back when no more items follow. \pre there are none
  void release() {
    verify::release(texts);
    verify::release(places);
  }
  [[nodiscard]] std::uint64_t bytes() const {
    return texts.capacity() + places.capacity() * sizeof(Place) + file->bytes();
  }

private:
  struct Place {
    std::uint64_t number = 0;
    std::uint64_t offset = 0;
    std::uint32_t length = 0;
  };
  /// The next item of a run.
  struct Cursor {
    PageReader reader;
    std::uint64_t number = 0;
    std::string text;
    bool atEnd = false;
  };
  struct Run {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
  };
  using VisitItem = std::function<void(std::uint64_t, std::string_view)>;

  [[nodiscard]] std::string_view textOf(const Place& place) const {
    return std::string_view(texts).substr(place.offset, place.length);
  }
  void sort();
  void writeRun();
  void mergeRuns();
  void eachOfRuns(const VisitItem& visit) const;
  static void advance(Cursor& cursor);
  static void write(PagedFile& to, std::uint64_t number, std::string_view text);

  SpillSpace& space;
  std::uint64_t most; ///< bytes in memory
  std::string texts;
  std::vector<Place> places;
  std::unique_ptr<PagedFile> file;
  std::vector<Run> runs;
};

} // namespace proskill::verify
