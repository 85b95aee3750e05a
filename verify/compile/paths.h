#pragma once

#include "verify/compile/expressions.h"

#include <functional>

namespace proskill::verify {

/// What the statements of a process may name.
struct PathContext {
  InstanceId instance = 0;
  const fiacre::Process* process = nullptr;
  CellId location = 0;
  const Scope* scope = nullptr;
  std::map<std::string, std::uint32_t, std::less<>> ports; ///< formal name to System::ports
  std::vector<bool> portIsTimed;                           ///< by port: neither [0,0] nor [0,...[
  std::function<EventId(const std::string&)> tag;          ///< the event of a tag, made when new
  std::function<EventId(std::uint32_t)> entering;          ///< a location
  std::uint32_t nextLeaf = 0; ///< counts over all `from`s of the process
  std::uint32_t selects = 0;  ///< likewise: those with `unless`

  /// The types of what crosses a port, by its formal name.
  [[nodiscard]] const std::vector<fiacre::Type>& valuesOf(const std::string& port) const;
};

/// Normalises the statement of a `from` into its paths. `select` branches; an `if` or `case` with a
/// wait, a port or a `select` inside splits the path, with its condition as a guard; any other
/// stays a choice within one path. A path that waits is split further by where it ends, so that
/// each transition has one target, as in Fiacre: this matters to clocks alone. \throw CompileError
[[nodiscard]] std::vector<Path> pathsOf(const fiacre::From& from, std::uint32_t location,
                                        PathContext& context, Expressions& expressions);

} // namespace proskill::verify
