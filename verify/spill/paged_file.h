#pragma once

#include "verify/spill/spill_space.h"

#include <cstddef>
#include <vector>

namespace proskill::verify {

/// A file that grows, and of which any part can be read. It consists of pages, whose hashes are
/// kept in memory: so a file that somebody has shortened or changed is noticed when it is read. The
/// last page is in memory until it is full, so a small file is not written at all.
class PagedFile {
public:
  /// \pre the argument outlives this
  explicit PagedFile(SpillSpace& of) : space(of), pageBytes(of.pageBytes()) {}
  PagedFile(const PagedFile&) = delete;
  PagedFile& operator=(const PagedFile&) = delete;
  ~PagedFile() { space.noteRemoved(written()); }

  void byte(std::uint8_t value) {
    last.push_back(static_cast<char>(value));
    if (last.size() == pageBytes) writePage();
  }
  /// Seven bits a byte, the lowest first.
  void number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) byte(static_cast<std::uint8_t>(value | 0x80));
    byte(static_cast<std::uint8_t>(value));
  }
  void add(std::string_view bytes);
  /// Removes the content. \throw LimitMet
  void clear();

  /// Number of bytes that were added.
  [[nodiscard]] std::uint64_t size() const { return written() + last.size(); }
  [[nodiscard]] std::size_t bytesOfPage() const { return pageBytes; }
  /// Reads the page in which a byte is. \throw LimitMet if the disk does not have it any more
  void readPageOf(std::uint64_t at, std::vector<char>& page) const;
  /// Bytes of memory.
  [[nodiscard]] std::uint64_t bytes() const {
    return last.capacity() + hashes.capacity() * sizeof(std::uint64_t);
  }

private:
  [[nodiscard]] std::uint64_t written() const { return hashes.size() * pageBytes; }
  void writePage();

  SpillSpace& space;
  std::size_t pageBytes;
  std::unique_ptr<SpillFile> file; ///< once a page is full
  std::vector<std::uint64_t> hashes;
  std::vector<char> last;
};

/// Reads a part of a file from its beginning.
class PageReader {
public:
  PageReader() = default;
  /// \pre the file outlives this
  PageReader(const PagedFile& of, std::uint64_t begin, std::uint64_t end) : file(&of), last(end) {
    seek(begin);
  }

  [[nodiscard]] bool isAtEnd() const { return position() == last; }
  [[nodiscard]] std::uint64_t position() const { return pageAt + at; }
  /// Goes on at another place.
  void seek(std::uint64_t to);
  void skip(std::uint64_t bytes) { seek(position() + bytes); }

  [[nodiscard]] std::uint8_t byte() {
    if (at == page.size()) refill();
    return static_cast<std::uint8_t>(page[at++]);
  }
  [[nodiscard]] std::uint64_t number() {
    std::uint64_t value = byte();
    if (value < 0x80) return value;
    value &= 0x7F;
    for (unsigned shift = 7; shift < 64; shift += 7) {
      const std::uint64_t next = byte();
      value |= (next & 0x7F) << shift;
      if (next < 0x80) break;
    }
    return value;
  }
  /// Appends so many bytes to a text.
  void read(std::uint64_t bytes, std::string& to);

private:
  void refill();

  const PagedFile* file = nullptr;
  std::uint64_t last = 0;
  std::uint64_t pageAt = 0; ///< where the page begins
  std::size_t at = 0;       ///< in the page
  std::vector<char> page;   ///< empty: not read yet
};

} // namespace proskill::verify
