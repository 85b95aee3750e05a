#pragma once

#include "verify/memory/large_vector.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace proskill::verify {

/// A growing list of numbers that takes as many bits for each as the greatest of them needs: none
/// while all are 0. It grows in pieces, so that growing never copies the list.
class Column {
public:
  Column() = default;
  Column(const Column&) = delete;
  Column& operator=(const Column&) = delete;
  ~Column() = default;

  [[nodiscard]] std::uint32_t at(std::size_t i) const {
    if (width == 0) return 0;
    return read(pieces[i / kPiece], i % kPiece, width);
  }
  void push(std::uint32_t number) {
    if (count == pieces.size() * kPiece && width != 0) addBlock();
    ++count;
    if (number != 0) set(count - 1, number);
  }
  /// \pre i < size()
  void set(std::size_t i, std::uint32_t number) {
    if (bitsOf(number) > width) widen(number);
    if (width != 0) write(pieces[i / kPiece], i % kPiece, width, number);
  }
  [[nodiscard]] std::size_t size() const { return count; }
  [[nodiscard]] std::uint64_t bytes() const {
    return bytesOfBlocks + small.capacity() * sizeof(SmallBlock) +
           large.capacity() * sizeof(LargeBlock) + pieces.capacity() * sizeof(std::uint8_t*);
  }
  /// Bytes that the next few numbers may allocate at once.
  [[nodiscard]] std::uint64_t growth() const {
    return count + kBetweenGrowthChecks > pieces.size() * kPiece ? sizeOfNextBlock() : 0;
  }
  /// Asks the processor to load an entry soon.
  void prefetch(std::size_t i) const {
    if (width != 0) __builtin_prefetch(pieces[i / kPiece] + i % kPiece * width / 8);
  }

private:
  using SmallBlock = std::unique_ptr<std::uint8_t[]>; ///< one piece
  using LargeBlock = LargeVector<std::uint8_t>;       ///< many pieces
  static constexpr std::size_t kPiece = 4096;         ///< entries of a piece

  [[nodiscard]] std::size_t bytesOfPiece() const { return kPiece / 8 * width; }
  /// A column that is several times as large as a large block has large ones.
  [[nodiscard]] bool isLarge() const { return pieces.size() * bytesOfPiece() >= 4 * kLargeTable; }
  [[nodiscard]] std::size_t sizeOfNextBlock() const;
  void addBlock();
  /// Numbers have their lowest byte first, as on all processors that there are packages for.
  [[nodiscard]] static std::uint64_t load(const std::uint8_t* from) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, from, sizeof bits);
    return bits;
  }
  /// The entry at an index of a piece, all of whose entries have `width` bits.
  [[nodiscard]] static std::uint32_t read(const std::uint8_t* piece, std::size_t at,
                                          std::uint32_t width) {
    const std::size_t bit = at * width;
    return static_cast<std::uint32_t>(load(piece + bit / 8) >> bit % 8 & maskOf(width));
  }
  static void write(std::uint8_t* piece, std::size_t at, std::uint32_t width,
                    std::uint32_t number) {
    const std::size_t bit = at * width;
    const std::uint64_t around =
        (load(piece + bit / 8) & ~(maskOf(width) << bit % 8)) | std::uint64_t{number} << bit % 8;
    std::memcpy(piece + bit / 8, &around, sizeof around);
  }
  [[nodiscard]] static std::uint32_t bitsOf(std::uint32_t number) {
    return static_cast<std::uint32_t>(std::bit_width(number));
  }
  [[nodiscard]] static std::uint64_t maskOf(std::uint32_t width) {
    return (std::uint64_t{1} << width) - 1;
  }
  void widen(std::uint32_t number);

  std::uint32_t width = 0; ///< bits of each
  std::size_t count = 0;
  std::vector<std::uint8_t*> pieces; ///< in the blocks
  std::vector<SmallBlock> small;     ///< those of the first pieces
  std::vector<LargeBlock> large;     ///< those of the others
  std::uint64_t bytesOfBlocks = 0;
};

} // namespace proskill::verify
