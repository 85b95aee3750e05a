#include "verify/space/column.h"

#include "verify/model/release.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

std::size_t Column::sizeOfNextBlock() const {
  const std::size_t piece = bytesOfPiece();
  const std::size_t count = isLarge() ? kLargeTable / piece + 1 : 1;
  return count * piece + sizeof(std::uint64_t); // entries are read as eight bytes
}

void Column::addBlock() {
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
void Column::widen(std::uint32_t number) {
  const auto before = std::exchange(width, bitsOf(number));
  const auto narrow = std::exchange(pieces, {});
  auto oldSmall = std::exchange(small, {});
  auto oldLarge = std::exchange(large, {});
  bytesOfBlocks = 0;
  for (std::size_t piece = 0, used = 0; piece * kPiece < count; ++piece) {
    if (piece == pieces.size()) addBlock();
    if (before == 0) continue;
    if (used + 1 < oldLarge.size() && narrow[piece] == oldLarge[used + 1].data())
      release(oldLarge[used++]);
    const std::size_t entries = std::min(kPiece, count - piece * kPiece);
    for (std::size_t i = 0; i < entries; ++i)
      write(pieces[piece], i, width, read(narrow[piece], i, before));
    if (piece < oldSmall.size()) oldSmall[piece].reset();
  }
}

} // namespace proskill::verify
