#pragma once

#include "fiacre/syntax/parse.h"

#include <catch2/catch.hpp>

#include <string>

namespace proskill::test {

/// A model from text. \pre it has no errors
inline fiacre::Parsed model(const std::string& text) {
  auto parsed = fiacre::parse(text);
  for (const auto& problem : parsed.problems) FAIL(problem.message << " in\n" << text);
  return parsed;
}

} // namespace proskill::test
