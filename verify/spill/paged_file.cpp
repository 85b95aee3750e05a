#include "verify/spill/paged_file.h"

#include "verify/state/store.h"

#include <cstring>

namespace proskill::verify {

namespace {

std::uint64_t hashOf(std::span<const char> page) {
  std::uint64_t hash = page.size();
  for (std::size_t i = 0; i < page.size(); i += sizeof hash) { // pages have whole words
    std::uint64_t word = 0;
    std::memcpy(&word, page.data() + i, sizeof word);
    hash = mix(hash, word);
  }
  return hash;
}

/// \throw LimitMet
void require(const SpillFile::Done& done) {
  if (!done) throw LimitMet{done.error()};
}

} // namespace

std::unique_ptr<SpillFile> SpillSpace::create() {
  auto made = store.create();
  if (!made) throw LimitMet{made.error()};
  return std::move(*made);
}

void PagedFile::writePage() {
  space.checkLimits();
  if (!file) file = space.create();
  require(file->append({last.data(), last.size()}));
  hashes.push_back(hashOf(last));
  space.noteWritten(pageBytes);
  last.clear();
}

void PagedFile::add(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t now = std::min(bytes.size(), pageBytes - last.size());
    last.insert(last.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(now));
    bytes.remove_prefix(now);
    if (last.size() == pageBytes) writePage();
  }
}

void PagedFile::clear() {
  space.noteRemoved(written());
  hashes.clear();
  last.clear();
  if (file) require(file->clear());
}

void PagedFile::readPageOf(std::uint64_t at, std::vector<char>& page) const {
  const std::uint64_t number = at / pageBytes;
  if (number >= hashes.size()) {
    page = last;
    return;
  }
  space.checkLimits();
  page.resize(pageBytes);
  require(file->read(number * pageBytes, page));
  if (hashOf(page) != hashes[number])
    throw LimitMet{"a file of the search on disk was changed by another program"};
}

void PageReader::seek(std::uint64_t to) {
  const std::uint64_t start = to / file->bytesOfPage() * file->bytesOfPage();
  if (start != pageAt || to - start > page.size()) page.clear();
  pageAt = start;
  at = page.empty() ? 0 : static_cast<std::size_t>(to - start);
  if (!page.empty() || to == start) return;
  file->readPageOf(start, page);
  at = static_cast<std::size_t>(to - start);
}

void PageReader::refill() {
  const std::uint64_t next = pageAt + at;
  pageAt = next / file->bytesOfPage() * file->bytesOfPage();
  file->readPageOf(pageAt, page);
  at = static_cast<std::size_t>(next - pageAt);
  if (at >= page.size()) throw LimitMet{"a file of the search on disk ends too early"};
}

void PageReader::read(std::uint64_t bytes, std::string& to) {
  while (bytes > 0) {
    if (at == page.size()) refill();
    const std::size_t now = std::min<std::uint64_t>(bytes, page.size() - at);
    to.append(page.data() + at, now);
    at += now;
    bytes -= now;
  }
}

} // namespace proskill::verify
