#pragma once

#include "verify/space/root_matrix.h"
#include "verify/state/store.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

namespace proskill::verify {

/// A root that is looked for, with its hash.
struct SoughtRoot {
  Root root;
  std::uint64_t hash = 0;

  SoughtRoot() = default;
  explicit SoughtRoot(const Root& of) : root(of) {
    hash = mix(0, std::uint64_t{root.left} << 32 | root.right);
    hash = mix(hash, hash >> 32);
  }
};

/// The roots of states, each stored once and numbered in the order in which they are added.
///
/// Threads that search at once may *claim* roots that are not stored: a claim takes a place in the
/// table but no number. Afterwards one thread settles the claims in the order that it wants the
/// numbers to have, so that numbers do not depend on which thread was faster.
///
/// Who needs to know only whether a root is stored can do without numbers. Then a table becomes a
/// matrix of bits while this takes less memory.
class RootTable {
public:
  using ClaimId = std::uint32_t;
  /// Stands for the number of a root that is stored, and whose number the table does not know.
  static constexpr StateId kStored = kNone - 1;

  struct Added {
    StateId id = 0;
    bool isNew = false;
  };
  /// What findOrClaim() has found: a number, or a claim and who made it, or neither.
  struct Found {
    StateId id = kNone;
    ClaimId claim = kNone;
    std::uint32_t claimant = 0;
    bool isNew = false; ///< the claim was made by this call
  };
  /// Claims that one thread may make without asking the others.
  struct Allotment {
    ClaimId next = 0;
    ClaimId end = 0;
  };

  RootTable();

  /// From now on, kStored may stand for the number of a root that is looked for.
  void forgetNumbers() { knowsNumbers = false; }
  /// From now on, all numbers are known again. Call this while no other thread uses the table.
  void learnNumbers();

  Added add(const SoughtRoot& root);
  /// The number of a root; kNone if it has none. Several threads may call this at once, also while
  /// others call findOrClaim().
  [[nodiscard]] StateId find(const SoughtRoot& root) const;
  [[nodiscard]] Root at(StateId id) const { return roots.at(id); }
  /// Asks the processor to load what the other functions will look at.
  void prefetchSlot(const SoughtRoot& root) const {
    if (matrix) return matrix->prefetch(root.root);
    __builtin_prefetch(&slots[slotOf(root.hash)]);
  }
  void prefetchState(const SoughtRoot& root) const {
    const Entry entry = load(slotOf(root.hash)) & numberMask;
    if (entry - 1 >= numbered()) return; // nothing, or a claim
    roots.prefetch(entry - 1);
  }

  /// Ends the claims that were made so far, and whose number nobody needed.
  /// \param most number of claims that are wanted at most
  /// \return whether the table has to grow before claims can be made
  [[nodiscard]] bool prepareClaims(std::size_t most);
  /// The claims that can be made are below this.
  [[nodiscard]] std::size_t claimCapacity() const { return claims.size(); }
  /// Grows the table. Afterwards refill() must be called for each of `parts` parts, before anything
  /// else; several threads may do so at once.
  void startGrowth();
  void refill(std::size_t part, std::size_t parts);
  /// Finds a root, or claims it. Several threads may call this at once, after prepareClaims().
  /// Returns neither number nor claim if no claims are left.
  /// \param own belongs to the calling thread; {} after prepareClaims()
  [[nodiscard]] Found findOrClaim(const SoughtRoot& root, std::uint32_t claimant, Allotment& own);
  /// Numbers a claimed root, unless that has been done.
  Added settle(ClaimId claim);

  [[nodiscard]] std::uint32_t size() const { return count; }
  [[nodiscard]] std::uint64_t bytes() const {
    return slots.capacity() * sizeof(std::uint32_t) + (matrix ? matrix->bytes() : 0) +
           roots.bytes() + claims.capacity() * sizeof(Claim);
  }
  /// Bytes that the next few insertions may allocate at once.
  [[nodiscard]] std::uint64_t growth() const;

private:
  struct Claim {
    Root root;
    std::uint32_t claimant = 0;
    StateId id = kNone; ///< once it is settled
    std::size_t slot = 0;
  };
  /// What a slot holds below some bits of the hash: 0, a number plus 1, a claim, or `numberMask`
  /// for a claim that has ended. Claims are counted down from there, so that numbers do not reach
  /// them.
  using Entry = std::uint32_t;

  [[nodiscard]] std::size_t slotOf(std::uint64_t hash) const {
    return static_cast<std::size_t>((hash >> 32) * slots.size() >> 32);
  }
  [[nodiscard]] std::uint32_t tagOf(std::uint64_t hash) const {
    return static_cast<std::uint32_t>(hash) & ~numberMask;
  }
  [[nodiscard]] std::uint32_t load(std::size_t slot) const {
    return __atomic_load_n(&slots[slot], __ATOMIC_ACQUIRE);
  }
  /// Fills a slot unless another thread has just done so. \return what is in it otherwise; 0 if not
  std::uint32_t fill(std::size_t slot, std::uint32_t value);
  [[nodiscard]] std::size_t after(std::size_t slot) const {
    return slot + 1 == slots.size() ? 0 : slot + 1;
  }
  [[nodiscard]] Entry entryOf(ClaimId claim) const { return numberMask - 1 - claim; }
  [[nodiscard]] ClaimId claimOf(Entry entry) const { return numberMask - 1 - entry; }
  [[nodiscard]] bool holds(Entry entry, const Root& root) const {
    if (entry <= numbered()) return roots.at(entry - 1) == root;
    return entry != numberMask && claims[claimOf(entry)].root == root;
  }
  /// Number of roots that have a slot, and not a bit of the matrix.
  [[nodiscard]] std::uint32_t numbered() const { return matrix ? 0 : count; }
  [[nodiscard]] std::uint64_t bytesOfNextMatrix(std::uint32_t more) const;
  [[nodiscard]] bool isMatrixSmaller(std::uint64_t bytes) const;
  [[nodiscard]] std::size_t slotsOfNextTable(std::size_t more) const;
  void makeSlots(std::size_t size);
  void refillMatrix(std::size_t part, std::size_t parts);
  void endClaims();
  [[nodiscard]] std::size_t seek(const SoughtRoot& sought) const;
  [[nodiscard]] std::size_t put(std::uint64_t hash, Entry entry);
  [[nodiscard]] bool reserveClaim(Allotment& own);
  [[nodiscard]] ClaimId claimsEnd() const {
    return std::min(allotted.load(), static_cast<ClaimId>(claims.size()));
  }
  /// Number of slots that are used, or about to be.
  [[nodiscard]] std::size_t used() const { return count + dead + claimsEnd() - settled; }
  StateId push(const Root& root);
  template <class Visit> void eachOpenClaim(Visit visit);
  void grow();

  std::uint32_t count = 0;
  Roots roots;
  LargeVector<std::uint32_t> slots; ///< 0, or an entry below more bits of the hash
  std::uint32_t numberMask = 0;
  std::size_t dead = 0; ///< slots of claims that have ended
  bool knowsNumbers = true;
  std::optional<RootMatrix> matrix; ///< then the slots are those of claims only

  std::vector<Claim> claims; ///< as many as may be made
  std::atomic<ClaimId> allotted{0};
  std::size_t settled = 0;
};

} // namespace proskill::verify
