#pragma once

#include "include/proskill/platform.h"

#include <expected>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace proskill::host {

/// What performs the action of a skill: one of the two is there.
struct Function {
  using Perform = const char*(proskill_run, const proskill_value*, std::size_t);
  using Begin = void(proskill_run, const proskill_value*, std::size_t);

  Perform* perform = nullptr; ///< blocks
  Begin* begin = nullptr;     ///< returns soon
};

/// Why a library does not suit the program.
struct Unsuited {
  std::string why;
  std::string skill; ///< that has no function; empty: it is not about one
};

/// A shared library that performs actions. It is never unloaded: threads of its own may run in it.
class Library {
public:
  /// \param path of a file; the error says why it cannot be loaded
  [[nodiscard]] static std::expected<Library, std::string> load(const std::string& path,
                                                                const proskill_host& host);

  /// The functions for these skills. \param named by skill: the names of those that are not called
  /// after it
  [[nodiscard]] std::expected<std::map<std::string, Function>, Unsuited>
  functionsFor(const std::vector<std::string>& skills,
               const std::map<std::string, std::string>& named) const;

  /// Has the library prepare itself. \return why it cannot; empty: it did, or has nothing to do
  [[nodiscard]] std::string open() const;
  void close() const;
  [[nodiscard]] const std::string& name() const { return path; }

private:
  Library(void* loaded, std::string from) : handle(loaded), path(std::move(from)) {}
  [[nodiscard]] void* symbol(const std::string& name) const;
  [[nodiscard]] Function functionFor(const std::string& skill) const;

  void* handle;
  std::string path;
};

} // namespace proskill::host
