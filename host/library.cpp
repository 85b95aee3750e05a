#include "host/library.h"

#include <fmt/format.h>

#include <dlfcn.h>
#include <filesystem>

namespace proskill::host {

namespace {

/// Replaces the characters of a skill's name that are invalid in C.
std::string identifier(std::string name) {
  for (char& c : name)
    if (!(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z') && !(c >= '0' && c <= '9')) c = '_';
  return name;
}

template <class Type> Type* functionAt(void* address) { return reinterpret_cast<Type*>(address); }

} // namespace

std::expected<Library, std::string> Library::load(const std::string& path,
                                                  const proskill_host& host) {
  std::error_code none;
  if (!std::filesystem::exists(path, none))
    return std::unexpected(fmt::format("there is no file `{}`", path));
  // dlopen searches the system's directories for a name without a slash
  void* handle = dlopen(std::filesystem::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) return std::unexpected(fmt::format("`{}` cannot be loaded: {}", path, dlerror()));
  Library library(handle, path);
  auto* mark = static_cast<proskill_library*>(library.symbol("proskill_this_library"));
  if (!mark)
    return std::unexpected(
        fmt::format("`{}` is not a platform: write `PROSKILL_LIBRARY;` in one of its files, after "
                    "`#include <proskill/platform.h>`",
                    path));
  if (mark->abi != PROSKILL_ABI)
    return std::unexpected(fmt::format("`{}` was compiled with version {} of platform.h, and this "
                                       "proskill has version {}: compile it again",
                                       path, mark->abi, PROSKILL_ABI));
  mark->host = &host;
  return library;
}

void* Library::symbol(const std::string& name) const { return dlsym(handle, name.c_str()); }

Function Library::functionFor(const std::string& skill) const {
  const auto name = identifier(skill);
  if (auto* perform = symbol("skill_" + name))
    return {.perform = functionAt<Function::Perform>(perform)};
  return {.begin = functionAt<Function::Begin>(symbol("begin_" + name))};
}

std::expected<std::map<std::string, Function>, Unsuited>
Library::functionsFor(const std::vector<std::string>& skills,
                      const std::map<std::string, std::string>& named) const {
  std::map<std::string, Function> all;
  for (const auto& skill : skills) {
    const auto other = named.find(skill);
    auto& function = all[skill];
    if (other == named.end())
      function = functionFor(skill);
    else if (other->second.starts_with("begin_"))
      function.begin = functionAt<Function::Begin>(symbol(other->second));
    else
      function.perform = functionAt<Function::Perform>(symbol(other->second));
    if (function.perform || function.begin) continue;
    const auto name = identifier(skill);
    const auto missing = other == named.end()
                             ? fmt::format("neither `skill_{}` nor `begin_{}`", name, name)
                             : fmt::format("no `{}`", other->second);
    return std::unexpected(
        Unsuited{fmt::format("`{}` has no function for `{}`: {}", path, skill, missing), skill});
  }
  return all;
}

std::string Library::open() const {
  auto* const open = functionAt<const char*()>(symbol("proskill_open"));
  const char* why = open ? open() : nullptr;
  return why ? fmt::format("`{}` cannot begin: {}", path, why) : "";
}

void Library::close() const {
  if (auto* const close = functionAt<void()>(symbol("proskill_close"))) close();
}

} // namespace proskill::host
