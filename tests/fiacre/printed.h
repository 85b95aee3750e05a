#pragma once

#include "fiacre/print/print.h"
#include "tests/fiacre/build.h"

#include <catch2/catch.hpp>

namespace proskill::fiacre::test {

/// What a process `p` with one state prints below its `from`.
inline std::string printed(std::vector<Statement> statements) {
  Program program{.processes = {process("p", {"s"}, {from("s", std::move(statements))})}};
  const auto text = print(program);
  const std::string head = "process p is\nstates s\n\nfrom s\n";
  REQUIRE(text.starts_with(head));
  return "\n" + text.substr(head.size());
}

} // namespace proskill::fiacre::test
