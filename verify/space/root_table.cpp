#include "verify/space/root_table.h"

#include "verify/model/release.h"
#include <array>
#include <bit>

namespace proskill::verify {

namespace {

constexpr std::size_t kFewestSlots = 256;
constexpr std::uint32_t kAllotment = 32;
constexpr std::size_t kNowhere = SIZE_MAX;
constexpr std::uint32_t kNewHalves = 512;    ///< of states, at most, between two checks of growth
constexpr std::uint64_t kSmallMatrix = 4096; ///< bytes that any table may take

/// Whether a table with so many slots has to grow before another entry.
bool isFull(std::size_t count, std::size_t slots) { return (count + 1) * 20 > slots * 17; }

std::size_t grown(std::size_t slots) { return slots + slots / 5 * 2; }

} // namespace

RootTable::RootTable() : slots(kFewestSlots), numberMask(kFewestSlots - 1) {}

/// The slot of a root, or the empty slot for it.
std::size_t RootTable::seek(const SoughtRoot& sought) const {
  const std::uint32_t mask = numberMask;
  const std::uint32_t tag = tagOf(sought.hash);
  std::size_t at = slotOf(sought.hash);
  for (std::uint32_t value = load(at); value != 0; value = load(at)) {
    if ((value & ~mask) == tag && holds(value & mask, sought.root)) return at;
    at = after(at);
  }
  return at;
}

StateId RootTable::find(const SoughtRoot& root) const {
  if (matrix) return matrix->contains(root.root) ? kStored : kNone;
  const Entry entry = load(seek(root)) & numberMask;
  return entry == 0 || entry > count ? kNone : entry - 1;
}

StateId RootTable::push(const Root& root) {
  roots.push(root);
  ++count;
  if (matrix && matrix->hasRoomFor(root))
    matrix->insert(root);
  else if (matrix)
    grow();
  return count - 1;
}

RootTable::Added RootTable::add(const SoughtRoot& root) {
  if (!matrix && isFull(used(), slots.size())) grow();
  if (matrix && matrix->contains(root.root)) return {kStored, false};
  const std::size_t at = seek(root);
  const Entry entry = slots[at] & numberMask;
  if (entry > numbered()) return settle(claimOf(entry));
  if (entry != 0) return {entry - 1, false};
  if (!matrix) slots[at] = tagOf(root.hash) | (count + 1);
  return {push(root.root), true};
}

std::uint32_t RootTable::fill(std::size_t slot, std::uint32_t value) {
  std::uint32_t before = 0;
  __atomic_compare_exchange_n(&slots[slot], &before, value, false, __ATOMIC_ACQ_REL,
                              __ATOMIC_ACQUIRE);
  return before;
}

bool RootTable::reserveClaim(Allotment& own) {
  if (own.next < own.end) return true;
  if (allotted.load(std::memory_order_relaxed) >= claims.size()) return false;
  const ClaimId first = allotted.fetch_add(kAllotment, std::memory_order_relaxed);
  if (first + kAllotment > claims.size()) return false;
  own = {first, first + kAllotment};
  for (ClaimId i = own.next; i < own.end; ++i) claims[i] = {{}, 0, kNone, kNowhere};
  return true;
}

RootTable::Found RootTable::findOrClaim(const SoughtRoot& root, std::uint32_t claimant,
                                        Allotment& own) {
  if (matrix && matrix->contains(root.root)) return {kStored, kNone, 0, false};
  const std::uint32_t tag = tagOf(root.hash);
  for (std::size_t at = slotOf(root.hash);; at = after(at)) {
    std::uint32_t value = load(at);
    if (value == 0) {
      if (!reserveClaim(own)) return {};
      Claim& mine = claims[own.next];
      mine.root = root.root;
      mine.claimant = claimant;
      value = fill(at, tag | entryOf(own.next));
      if (value == 0) {
        mine.slot = at;
        return {kNone, own.next++, claimant, true};
      }
    }
    const Entry entry = value & numberMask;
    if ((value & ~numberMask) != tag || !holds(entry, root.root)) continue;
    if (entry <= numbered()) return {entry - 1, kNone, 0, false};
    return {kNone, claimOf(entry), claims[claimOf(entry)].claimant, false};
  }
}

RootTable::Added RootTable::settle(ClaimId claim) {
  Claim& it = claims[claim];
  if (it.id != kNone) return {it.id, false};
  ++settled;
  it.id = count;
  if (!matrix) slots[it.slot] = (slots[it.slot] & ~numberMask) | (it.id + 1);
  push(it.root);
  return {it.id, true};
}

template <class Visit> void RootTable::eachOpenClaim(Visit visit) {
  for (ClaimId i = 0; i < claimsEnd(); ++i)
    if (claims[i].id == kNone && claims[i].slot != kNowhere) visit(i);
}

bool RootTable::prepareClaims(std::size_t most) {
  if (matrix)
    makeSlots(std::max(slots.size(), 2 * most));
  else
    endClaims();
  allotted = 0;
  settled = 0;
  claims.resize(std::min(most, slots.size() / (matrix ? 2 : 10)) / kAllotment * kAllotment);
  return !matrix && isFull(count + dead + claims.size(), slots.size());
}

void RootTable::endClaims() {
  eachOpenClaim([this](ClaimId claim) {
    slots[claims[claim].slot] |= numberMask;
    ++dead;
  });
}

/// Bytes of a matrix that has room for numbers which are greater by at most `more`.
std::uint64_t RootTable::bytesOfNextMatrix(std::uint32_t more) const {
  const Root greatest = roots.greatestNumbers();
  const auto bitsWith = [](std::uint32_t bits, std::uint64_t number) {
    return std::max(bits, static_cast<std::uint32_t>(std::bit_width(number)));
  };
  return RootMatrix::bytesFor(bitsWith(roots.leftWidth(), std::uint64_t{greatest.left} + more),
                              bitsWith(roots.rightWidth(), std::uint64_t{greatest.right} + more));
}

/// Whether a matrix takes less memory than a table would.
bool RootTable::isMatrixSmaller(std::uint64_t bytes) const {
  return !knowsNumbers &&
         bytes <= std::max<std::uint64_t>(kSmallMatrix, count * sizeof(std::uint32_t));
}

/// Slots of a table for what is stored and so many more entries.
std::size_t RootTable::slotsOfNextTable(std::size_t more) const {
  const std::size_t entries = used() + more;
  return std::max(grown(slots.size()), entries + entries / 3 * 2);
}

/// The old table is given back before the new one is made from the states.
void RootTable::startGrowth() {
  const std::size_t size = slotsOfNextTable(0);
  release(slots);
  matrix.reset();
  if (!isMatrixSmaller(bytesOfNextMatrix(0))) return makeSlots(size);
  matrix.emplace(roots);
  makeSlots(std::max(kFewestSlots, 2 * claims.size()));
}

/// Makes empty slots.
void RootTable::makeSlots(std::size_t size) {
  slots.assign(size, 0);
  numberMask = size >= std::size_t{1} << 31 ? UINT32_MAX
                                            : static_cast<std::uint32_t>(std::bit_ceil(size)) - 1;
  dead = 0;
}

void RootTable::grow() {
  startGrowth();
  refill(0, 1);
  eachOpenClaim([this](ClaimId claim) {
    claims[claim].slot = put(SoughtRoot(claims[claim].root).hash, entryOf(claim));
  });
}

/// Other threads fill slots, too, so the slots of the next few roots are loaded together.
void RootTable::refill(std::size_t part, std::size_t parts) {
  constexpr std::size_t kTogether = 16;
  if (matrix) return refillMatrix(part, parts);
  const std::size_t end = std::size_t{count} * (part + 1) / parts;
  std::array<std::uint64_t, kTogether> hashes{};
  for (std::size_t id = std::size_t{count} * part / parts; id < end; id += kTogether) {
    const std::size_t last = std::min(end, id + kTogether);
    for (std::size_t i = id; i < last; ++i) {
      hashes[i - id] = SoughtRoot(at(static_cast<StateId>(i))).hash;
      __builtin_prefetch(&slots[slotOf(hashes[i - id])], 1);
    }
    for (std::size_t i = id; i < last; ++i) (void)put(hashes[i - id], static_cast<Entry>(i + 1));
  }
}

void RootTable::refillMatrix(std::size_t part, std::size_t parts) {
  const std::size_t end = std::size_t{count} * (part + 1) / parts;
  for (std::size_t id = std::size_t{count} * part / parts; id < end; ++id)
    matrix->insert(at(static_cast<StateId>(id)));
}

void RootTable::learnNumbers() {
  knowsNumbers = true;
  if (matrix) grow();
}

std::size_t RootTable::put(std::uint64_t hash, Entry entry) {
  std::size_t at = slotOf(hash);
  while (fill(at, tagOf(hash) | entry) != 0) at = after(at);
  return at;
}

std::uint64_t RootTable::growth() const {
  const std::uint64_t next = bytesOfNextMatrix(kNewHalves);
  if (matrix ? next == matrix->bytes()
             : !isFull(used() + claims.size() + kBetweenGrowthChecks, slots.size()))
    return roots.growth();
  const std::uint64_t now = matrix ? matrix->bytes() : slots.size() * sizeof(Entry);
  const std::uint64_t then =
      isMatrixSmaller(next) ? next : slotsOfNextTable(kBetweenGrowthChecks) * sizeof(Entry);
  return roots.growth() + then - std::min(then, now);
}

} // namespace proskill::verify
