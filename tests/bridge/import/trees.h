#pragma once

#include "bridge/bt/import.h"
#include "tests/bridge/errors_text.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

#include <map>
#include <string>

/// Behavior trees of tests, and what becomes of them.
namespace proskill::test::trees {

inline std::string rooted(const std::string& inner, const std::string& attributes = "") {
  return "<root BTCPP_format=\"4\"" + attributes + ">\n" + inner + "</root>\n";
}

inline std::string treeOf(const std::string& node) {
  return rooted("<BehaviorTree ID=\"Main\">\n" + node + "\n</BehaviorTree>\n");
}

inline std::string errorsIn(const std::map<std::string, std::string>& files) {
  return errorsText(bridge::bt::importTree(MemoryFiles(files), "main.xml", bridge::Leaves(), {}));
}

inline std::string errorsIn(const std::string& xml) { return errorsIn({{"main.xml", xml}}); }

inline std::string textOf(const std::string& xml, const std::string& leaves = "{}") {
  const auto imported = bridge::bt::importTree(MemoryFiles({{"main.xml", xml}}), "main.xml",
                                               *bridge::Leaves::read(leaves), {});
  INFO(errorsText(imported));
  REQUIRE(imported);
  return imported->text;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace proskill::test::trees
