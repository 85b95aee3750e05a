#pragma once

#include "include/proskill/platform.h"

#include <expected>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace proskill::host {

/// Function that performs the action of a skill: exactly one of the two is set.
struct Function {
  using Perform = const char*(proskill_run, const proskill_value*, std::size_t);
  using Begin = void(proskill_run, const proskill_value*, std::size_t);

  Perform* perform = nullptr; ///< blocks until the action ends
  Begin* begin = nullptr;     ///< returns at once
};

/// Why a library does not fit the program.
struct Unsuited {
  std::string why;
  std::string skill; ///< the skill without a suitable function; empty if the error concerns the
                     ///< whole library
};

/// Shared library that performs actions. It is never unloaded, since its own threads may still run.
class Library {
public:
  /// \param path of a file
  /// \return an error message if it cannot be loaded
  [[nodiscard]] static std::expected<Library, std::string> load(const std::string& path,
                                                                const proskill_host& host);

  /// Finds the function of each of these skills.
  /// \param named by skill: functions whose names differ from the skill's
  [[nodiscard]] std::expected<std::map<std::string, Function>, Unsuited>
  functionsFor(const std::vector<std::string>& skills,
               const std::map<std::string, std::string>& named) const;

  /// Calls `proskill_open`, if the library has it.
  /// \return why the library cannot start; empty on success
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
