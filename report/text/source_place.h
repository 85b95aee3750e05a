#pragma once

#include "analysis/program/program.h"

#include <cstdint>
#include <string>

namespace proskill::report {

/// A place for users: line and column from 1, the column in characters.
struct SourcePlace {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

/// Computes places. It starts from the previous place, so that many places on one long line take
/// one pass.
class SourcePlaces {
public:
  explicit SourcePlaces(const analysis::Program& program) : program(program) {}

  [[nodiscard]] SourcePlace at(syntax::FileId file, syntax::Offset offset);
  [[nodiscard]] SourcePlace begin(analysis::Location location) {
    return at(location.file, location.range.begin);
  }
  [[nodiscard]] SourcePlace end(analysis::Location location) {
    return at(location.file, location.range.end);
  }
  [[nodiscard]] std::string path(syntax::FileId file) const {
    return program.files[file].path.generic_string();
  }

private:
  const analysis::Program& program;
  syntax::FileId lastFile = 0;
  syntax::Offset lastOffset = 0;
  SourcePlace last;
};

} // namespace proskill::report
