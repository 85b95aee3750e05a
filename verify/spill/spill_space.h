#pragma once

#include "verify/limits.h"
#include "verify/spill_store.h"

#include <algorithm>
#include <bit>

namespace proskill::verify {

/// The files of a search on disk, and the memory that it may use for its tables.
class SpillSpace {
public:
  /// \pre `of` and `watch` outlive this
  /// \param bytes of memory
  SpillSpace(SpillStore& of, LimitWatch& watch, std::uint64_t bytes)
      : store(of), limits(watch), memory(bytes) {}
  SpillSpace(const SpillSpace&) = delete;
  SpillSpace& operator=(const SpillSpace&) = delete;

  /// An empty file. \throw LimitMet if there can be none
  [[nodiscard]] std::unique_ptr<SpillFile> create();
  /// Bytes of the tables, each of which may use a share of them.
  [[nodiscard]] std::uint64_t memoryBytes() const { return memory; }
  /// Files are read and written in pages of so many bytes. Some fifty files are open at once.
  [[nodiscard]] std::size_t pageBytes() const {
    constexpr std::uint64_t kPagesInMemory = 512;
    constexpr std::uint64_t kFewest = 64;
    constexpr std::uint64_t kMost = std::uint64_t{64} << 10;
    return std::bit_floor(std::clamp(memory / kPagesInMemory, kFewest, kMost));
  }
  /// Call this for each page. \throw LimitMet
  void checkLimits() { limits.checkGrowth(std::uint64_t{0}); }
  void noteWritten(std::uint64_t bytes) {
    onDisk += bytes;
    peak = std::max(peak, onDisk);
  }
  void noteRemoved(std::uint64_t bytes) { onDisk -= bytes; }
  /// The greatest size of all files together.
  [[nodiscard]] std::uint64_t peakOnDisk() const { return peak; }

private:
  SpillStore& store;
  LimitWatch& limits;
  std::uint64_t memory;
  std::uint64_t onDisk = 0;
  std::uint64_t peak = 0;
};

} // namespace proskill::verify
