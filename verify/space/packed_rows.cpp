#include "verify/space/packed_rows.h"

#include "verify/model/release.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

namespace {

/// A row with zeros between its lowest bits and the others.
std::uint64_t withZeros(std::uint64_t row, std::uint32_t below, std::uint32_t more) {
  const std::uint64_t above = row >> below;
  const std::uint64_t lowest = row & PackedRows::maskOf(below);
  return above == 0 ? lowest : lowest | above << (below + more);
}

} // namespace

std::size_t PackedRows::sizeOfNextBlock() const {
  const std::size_t piece = bytesOfPiece();
  const std::size_t count = isLarge() ? kLargeTable / piece + 1 : 1;
  return count * piece + sizeof(std::uint64_t); // rows are read as eight bytes, and one more
}

void PackedRows::addBlock() {
  const std::size_t size = sizeOfNextBlock();
  bytesOfBlocks += size;
  if (!isLarge()) {
    small.push_back(std::make_unique<std::uint8_t[]>(size));
    pieces.push_back(small.back().get());
    return;
  }
  LargeBlock& made = large.emplace_back(size);
  const std::size_t piece = bytesOfPiece();
  for (std::size_t at = 0; at + piece <= size; at += piece) pieces.push_back(made.data() + at);
}

/// Copies one piece after the other, and gives back the old ones meanwhile.
void PackedRows::widen(std::uint32_t below, std::uint32_t more) {
  const auto before = std::exchange(width, width + more);
  const auto narrow = std::exchange(pieces, {});
  auto oldSmall = std::exchange(small, {});
  auto oldLarge = std::exchange(large, {});
  bytesOfBlocks = 0;
  for (std::size_t piece = 0, used = 0; piece * kPiece < count; ++piece) {
    if (piece == pieces.size()) addBlock();
    if (before == 0) continue;
    if (used + 1 < oldLarge.size() && narrow[piece] == oldLarge[used + 1].data())
      release(oldLarge[used++]);
    const std::size_t rows = std::min(kPiece, count - piece * kPiece);
    for (std::size_t i = 0; i < rows; ++i)
      write(pieces[piece], i, width, withZeros(read(narrow[piece], i, before), below, more));
    if (piece < oldSmall.size()) oldSmall[piece].reset();
  }
}

} // namespace proskill::verify
