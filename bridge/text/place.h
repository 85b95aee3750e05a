#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// Import of programs of other languages.
namespace proskill::bridge {

/// A place in one of the files that were read. Lines and columns count from 1, columns in bytes.
struct Place {
  std::filesystem::path file;
  std::uint64_t line = 1;
  std::uint64_t column = 1;

  friend bool operator==(const Place&, const Place&) = default;
};

/// What a file may not contain, or what cannot be translated, and where.
struct Error {
  Place place;
  std::string message;

  friend bool operator==(const Error&, const Error&) = default;
};

using Errors = std::vector<Error>;

/// What the translation had to approximate, and where.
using Note = Error;

} // namespace proskill::bridge
