#pragma once

#include "verify/memory/large_vector.h"

#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace proskill::verify {

/// A growing list of rows of a few bits each, as many for each row. It grows in pieces, so that
/// growing never copies the list.
class PackedRows {
public:
  PackedRows() = default;
  PackedRows(const PackedRows&) = delete;
  PackedRows& operator=(const PackedRows&) = delete;
  ~PackedRows() = default;

  /// Bits of each row, at most 64.
  [[nodiscard]] std::uint32_t rowWidth() const { return width; }
  [[nodiscard]] std::uint64_t at(std::size_t i) const {
    if (width == 0) return 0;
    return read(pieces[i / kPiece], i % kPiece, width);
  }
  /// \pre the row has no more bits than the others
  void push(std::uint64_t row) {
    if (count == pieces.size() * kPiece && width != 0) addBlock();
    ++count;
    if (row != 0) set(count - 1, row);
  }
  /// \pre i < size(), and the row has no more bits than the others
  void set(std::size_t i, std::uint64_t row) {
    if (width != 0) write(pieces[i / kPiece], i % kPiece, width, row);
  }
  /// Inserts zeros into each row.
  /// \param below the bits of a row that stay where they are: its lowest ones
  /// \param more bits; then all have at most 64
  void widen(std::uint32_t below, std::uint32_t more);

  [[nodiscard]] std::size_t size() const { return count; }
  [[nodiscard]] std::uint64_t bytes() const {
    return bytesOfBlocks + small.capacity() * sizeof(SmallBlock) +
           large.capacity() * sizeof(LargeBlock) + pieces.capacity() * sizeof(std::uint8_t*);
  }
  /// Bytes that the next few rows may allocate at once.
  [[nodiscard]] std::uint64_t growth() const {
    return count + kBetweenGrowthChecks > pieces.size() * kPiece ? sizeOfNextBlock() : 0;
  }
  /// Asks the processor to load a row soon.
  void prefetch(std::size_t i) const {
    if (width != 0) __builtin_prefetch(pieces[i / kPiece] + i % kPiece * width / 8);
  }
  /// The lowest bits. \pre width <= 64
  [[nodiscard]] static std::uint64_t maskOf(std::uint32_t width) {
    return width == 0 ? 0 : ~std::uint64_t{0} >> (64 - width);
  }

private:
  using SmallBlock = std::unique_ptr<std::uint8_t[]>; ///< one piece
  using LargeBlock = LargeVector<std::uint8_t>;       ///< many pieces
  static constexpr std::size_t kPiece = 4096;         ///< rows of a piece

  [[nodiscard]] std::size_t bytesOfPiece() const { return kPiece / 8 * width; }
  /// A list that is several times as large as a large block has large ones.
  [[nodiscard]] bool isLarge() const { return pieces.size() * bytesOfPiece() >= 4 * kLargeTable; }
  [[nodiscard]] std::size_t sizeOfNextBlock() const;
  void addBlock();
  /// Numbers have their lowest byte first, as on all processors that there are packages for.
  [[nodiscard]] static std::uint64_t load(const std::uint8_t* from) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, from, sizeof bits);
    return bits;
  }
  /// A row of a piece, all of whose rows have `width` bits.
  [[nodiscard]] static std::uint64_t read(const std::uint8_t* piece, std::size_t at,
                                          std::uint32_t width) {
    const std::size_t bit = at * width;
    const std::uint8_t* from = piece + bit / 8;
    std::uint64_t row = load(from) >> bit % 8;
    if (width + bit % 8 > 64) row |= std::uint64_t{from[8]} << (64 - bit % 8);
    return row & maskOf(width);
  }
  static void write(std::uint8_t* piece, std::size_t at, std::uint32_t width, std::uint64_t row) {
    const std::size_t bit = at * width;
    std::uint8_t* to = piece + bit / 8;
    const std::uint64_t around = (load(to) & ~(maskOf(width) << bit % 8)) | row << bit % 8;
    std::memcpy(to, &around, sizeof around);
    if (width + bit % 8 <= 64) return;
    const std::uint32_t beyond = 64 - bit % 8; // the bits of the row before the ninth byte
    to[8] = static_cast<std::uint8_t>((to[8] & ~(maskOf(width) >> beyond)) | row >> beyond);
  }

  std::uint32_t width = 0; ///< bits of each
  std::size_t count = 0;
  std::vector<std::uint8_t*> pieces; ///< in the blocks
  std::vector<SmallBlock> small;     ///< those of the first pieces
  std::vector<LargeBlock> large;     ///< those of the others
  std::uint64_t bytesOfBlocks = 0;
};

} // namespace proskill::verify
