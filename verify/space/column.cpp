#include "verify/space/column.h"

#include "verify/model/release.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

/// A column that is several times as large as a block has blocks of large pages.
std::size_t Column::sizeOfNextBlock() const {
  const std::size_t piece = bytesOfPiece();
  const bool isLarge = pieces.size() * piece >= 4 * kLargeTable;
  const std::size_t count = isLarge ? kLargeTable / piece + 1 : 1;
  return count * piece + sizeof(std::uint64_t); // entries are read as eight bytes
}

void Column::addBlock() {
  Block& made = blocks.emplace_back(sizeOfNextBlock());
  bytesOfBlocks += made.size();
  const std::size_t piece = bytesOfPiece();
  for (std::size_t at = 0; at + piece <= made.size(); at += piece)
    pieces.push_back(made.data() + at);
}

/// Copies one piece after the other, and gives back the old ones meanwhile.
void Column::widen(std::uint32_t number) {
  const auto before = std::exchange(width, bitsOf(number));
  const auto narrow = std::exchange(pieces, {});
  auto old = std::exchange(blocks, {});
  bytesOfBlocks = 0;
  for (std::size_t piece = 0, used = 0; piece * kPiece < count; ++piece) {
    if (piece == pieces.size()) addBlock();
    if (before == 0) continue;
    if (used + 1 < old.size() && narrow[piece] == old[used + 1].data()) release(old[used++]);
    const std::size_t entries = std::min(kPiece, count - piece * kPiece);
    for (std::size_t i = 0; i < entries; ++i)
      write(pieces[piece], i, width, read(narrow[piece], i, before));
  }
}

} // namespace proskill::verify
