#pragma once

#include "verify/compile/expressions.h"

#include <functional>

namespace proskill::verify {

/// The names and counters that the statements of a process use.
struct PathContext {
  InstanceId instance = 0;
  const fiacre::Process* process = nullptr;
  CellId location = 0;
  const Scope* scope = nullptr;
  /// From formal names to indices into System::ports.
  std::map<std::string, std::uint32_t, std::less<>> ports;
  std::vector<bool> portIsTimed;                  ///< by port: neither [0,0] nor [0,...[
  std::function<EventId(const std::string&)> tag; ///< the event of a tag, created when first used
  std::function<EventId(std::uint32_t)> entering; ///< the event of entering a location
  std::uint32_t nextLeaf = 0;                     ///< counts over all `from`s of the process
  std::uint32_t selects = 0; ///< number of `select`s with `unless`, over all `from`s of the process

  /// The types of the values sent on a port, by its formal name.
  [[nodiscard]] const std::vector<fiacre::Type>& valuesOf(const std::string& port) const;
};

/// Splits the statement of a `from` into its paths. A `select` splits the path. An `if` or `case`
/// that contains a wait, a port or a `select` splits it too, with its condition as a guard; any
/// other one stays a choice within the path. A path with a wait is split further by its targets, so
/// that each transition has one target as in Fiacre; this affects only clocks.
/// \throw CompileError
[[nodiscard]] std::vector<Path> pathsOf(const fiacre::From& from, std::uint32_t location,
                                        PathContext& context, Expressions& expressions);

} // namespace proskill::verify
