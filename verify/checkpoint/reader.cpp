#include "verify/checkpoint/reader.h"

namespace proskill::verify {

bool CheckpointReader::refill() {
  if (hasFailed()) return false;
  at = 0;
  block.clear();
  if (isAtEnd) return fail(), false;
  auto piece = next();
  if (!piece) return problem = std::move(piece.error()), false;
  block = std::move(*piece);
  isAtEnd = block.empty();
  return isAtEnd ? (fail(), false) : true;
}

std::uint64_t CheckpointReader::number() {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const std::uint8_t part = byte();
    value |= std::uint64_t{part & 0x7FU} << shift;
    if (part < 0x80) return hasFailed() ? 0 : value;
  }
  fail();
  return 0;
}

std::uint64_t CheckpointReader::numberBelow(std::uint64_t limit) {
  const std::uint64_t value = number();
  if (value < limit) return value;
  fail();
  return 0;
}

std::int64_t CheckpointReader::signedNumber() {
  const std::uint64_t value = number();
  return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
}

std::string CheckpointReader::text(std::size_t most) {
  std::string made;
  for (auto left = numberBelow(most + 1); left > 0 && !hasFailed(); --left)
    made.push_back(static_cast<char>(byte()));
  return hasFailed() ? std::string() : made;
}

void CheckpointReader::end() {
  if (hasFailed()) return;
  if (at < block.size()) return fail();
  if (isAtEnd) return;
  const auto piece = next();
  if (!piece)
    problem = piece.error();
  else if (!piece->empty())
    fail();
}

void CheckpointReader::fail() {
  if (problem.empty()) problem = "its content makes no sense";
}

} // namespace proskill::verify
