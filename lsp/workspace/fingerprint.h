#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace proskill::lsp {

/// Hash of a text as 16 hexadecimal digits, the same in every session: FNV-1a of the bytes.
[[nodiscard]] inline std::string fingerprint(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (unsigned char byte : text) hash = (hash ^ byte) * 1099511628211ULL;
  std::string digits(16, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, hash >>= 4)
    *digit = "0123456789abcdef"[hash & 15];
  return digits;
}

} // namespace proskill::lsp
