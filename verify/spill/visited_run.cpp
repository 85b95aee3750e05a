#include "verify/spill/visited_run.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::size_t kMostOfBlock = 2048; ///< bytes

} // namespace

VisitedRun::VisitedRun(SpillSpace& space, const SpillFormat& of)
    : format(of),
      blockBytes(std::min(kMostOfBlock, space.pageBytes())),
      file(space),
      before(of.words) {}

void VisitedRun::add(const Entry& entry, std::string_view zones) {
  if (offsets.empty() || file.size() - offsets.back() >= blockBytes) {
    offsets.push_back(file.size());
    firsts.insert(firsts.end(), entry.state.begin(), entry.state.end());
    std::ranges::fill(before, 0);
  }
  writeState(file, before, entry.state.data());
  if (!format.hasZones) return;
  file.number(2 * entry.zones + (entry.areMerged ? 1 : 0));
  file.number(entry.dimension);
  file.number(zones.size());
  file.add(zones);
}

VisitedRun::Cursor::Cursor(const VisitedRun& of) : run(of), reader(of.file, 0, of.file.size()) {
  current.state.resize(of.format.words);
}

bool VisitedRun::Cursor::next() {
  if (unread != 0) reader.skip(unread);
  unread = 0;
  isBefore = false;
  atEnd = reader.isAtEnd();
  if (!atEnd) readEntry();
  return !atEnd;
}

void VisitedRun::Cursor::readEntry() {
  if (block < run.offsets.size() && reader.position() == run.offsets[block]) {
    std::ranges::fill(current.state, 0);
    ++block;
  }
  readState(reader, current.state);
  if (!run.format.hasZones) return;
  const std::uint64_t zones = reader.number();
  current.zones = zones / 2;
  current.areMerged = zones % 2 != 0;
  current.dimension = static_cast<std::uint32_t>(reader.number());
  current.bytes = unread = reader.number();
}

bool VisitedRun::Cursor::find(const Word* state) {
  jumpTowards(state);
  if (isBefore) next();
  while (!atEnd) {
    const auto order = compareStates(current.state.data(), state, run.format.words);
    if (order >= 0) return order == 0;
    next();
  }
  return false;
}

/// Passes over whole blocks whose states are all smaller.
void VisitedRun::Cursor::jumpTowards(const Word* state) {
  const std::size_t words = run.format.words;
  const auto isAfter = [&](std::size_t at) {
    return at >= run.offsets.size() ||
           compareStates(run.firsts.data() + at * words, state, words) > 0;
  };
  if (isAfter(block)) return;
  std::size_t low = block; // not after the state
  std::size_t step = 1;
  while (!isAfter(low + step)) {
    low += step;
    step *= 2;
  }
  for (std::size_t high = low + step; high - low > 1;) {
    const std::size_t middle = low + (high - low) / 2;
    (isAfter(middle) ? high : low) = middle;
  }
  block = low;
  reader.seek(run.offsets[low]);
  unread = 0;
  isBefore = true;
}

void VisitedRun::Cursor::readZones(StateGroup& to) {
  to.dimension = current.dimension;
  for (std::uint64_t i = 0; i < current.zones; ++i) {
    if (run.format.hasZones)
      readZone(reader, current.dimension, to.bounds);
    else
      to.bounds.push_back(kZero);
  }
  unread = 0;
}

void VisitedRun::Cursor::readZones(std::string& to) {
  if (unread != 0) reader.read(unread, to);
  unread = 0;
}

} // namespace proskill::verify
