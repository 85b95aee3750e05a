#include "cache/digest.h"

#include "disk/disk.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace proskill::cache {

namespace {

std::string hex(XXH128_hash_t hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

} // namespace

std::string digestOf(std::string_view text) { return hex(XXH3_128bits(text.data(), text.size())); }

const std::string& digestOfThisProgram() {
  static const std::string digest = [] {
    const auto bytes = disk::DiskFileSystem().read("/proc/self/exe");
    return bytes ? digestOf(*bytes) : "";
  }();
  return digest;
}

} // namespace proskill::cache
