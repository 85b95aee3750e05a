#pragma once

#include "verify/slice/slicer.h"

#include <cstdint>
#include <vector>

namespace proskill::verify {

/// Cells that are the same field of different elements of an array, as the caller is in the record
/// of each skill. A mission waits for each of its calls in the same way, so a question that depends
/// on how it waits for one of them often depends on all.
class AlikeCells {
public:
  explicit AlikeCells(const Slicer& slicer);

  /// The cells, and those like one of them that are read by the guards of an instance whose guards
  /// read this one, too.
  [[nodiscard]] Bits with(const Bits& cells) const;

private:
  [[nodiscard]] Bits fieldsOf(const Bits& cells) const;

  std::vector<std::uint32_t> field; ///< by cell; kNone: it is not in an array
  std::vector<Bits> read;           ///< by instance: cells that its guards read
};

} // namespace proskill::verify
