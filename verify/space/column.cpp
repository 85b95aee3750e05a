#include "verify/space/column.h"

#include <algorithm>

namespace proskill::verify {

void Column::widen(std::uint32_t number) {
  const auto before = width;
  width = bitsOf(number);
  pieces.resize((count + kPiece - 1) / kPiece);
  for (std::size_t begin = 0; auto& piece : pieces) {
    Piece wider = makePiece(width);
    const std::size_t used = before == 0 ? 0 : std::min(kPiece, count - begin);
    for (std::size_t i = 0; i < used; ++i)
      write(wider.get(), i, width, read(piece.get(), i, before));
    piece = std::move(wider);
    begin += kPiece;
  }
}

} // namespace proskill::verify
