#pragma once

#include "groot/tree.h"
#include "runtime/executor/observer.h"

#include <functional>
#include <memory>

namespace proskill::groot {

/// Writes a run as BehaviorTree.CPP's FileLogger2 does, for Groot2: `BTCPP4-FileLogger2`, a version
/// in a byte, a length in 4 bytes and so much XML, the date of the start in 8 bytes, and 9 bytes
/// for each change of a node's status. Numbers are little-endian, times are in microseconds.
/// \param add appends to the file \param start of the run, in nanoseconds since 1970
/// \pre the executable outlives the observer
[[nodiscard]] std::unique_ptr<runtime::Observer> logOf(Tree tree,
                                                       const runtime::Executable& executable,
                                                       std::function<void(std::string_view)> add,
                                                       std::uint64_t start);

} // namespace proskill::groot
