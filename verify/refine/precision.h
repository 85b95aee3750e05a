#pragma once

#include "verify/explore/search.h"
#include "verify/refine/alike_cells.h"
#include "verify/slice/slicer.h"

namespace proskill::verify {

/// What the slices of a refinement know: the cells of the conditions that they do not omit, and
/// whether they have clocks. It grows by what false runs lack.
class Precision {
public:
  /// \param hasTime whether the first slice has clocks
  /// \pre the slicer outlives this
  explicit Precision(Slicer& of, bool hasTime = false) : slicer(&of), isTimed(hasTime) {}

  /// \throw LimitMet
  [[nodiscard]] Slice slice(SliceSeeds seeds) const;
  /// The slice's system; without clocks, a step that is possible may be taken at any time.
  [[nodiscard]] System systemOf(const Slice& slice) const;
  /// \param steps a run of the slice that is none of the whole
  /// \return whether the next slice knows more
  [[nodiscard]] bool growBy(const Slice& slice, const Steps& steps);

  /// The same with all cells that are like those it knows.
  [[nodiscard]] Precision widened(const AlikeCells& alike) const;
  /// Whether the two together know at most a quarter more than each of them.
  [[nodiscard]] bool isLike(const Precision& other) const;
  /// Adds what another one knows. \pre both have clocks, or none has
  void join(const Precision& other) { known |= other.known; }

  [[nodiscard]] bool hasTime() const { return isTimed; }
  [[nodiscard]] bool isRefined() const { return isTimed || !known.empty(); }
  friend bool operator==(const Precision&, const Precision&) = default;

private:
  [[nodiscard]] Bits readByLate(const Slice& slice) const;

  Slicer* slicer;
  Bits known;
  bool isTimed = false;
};

} // namespace proskill::verify
