#include "verify/model/nodes.h"
#include "verify/reduce/idle_tests.h"

#include <catch2/catch.hpp>

namespace proskill::test::idle_tests_test {

namespace {

using verify::Instruction;
using verify::InstructionKind;

constexpr verify::EventId kForbidden = 3;
constexpr verify::EventId kOther = 4;

/// A system with an instance and a number, and code of a path of this instance.
struct Coded {
  explicit Coded(std::vector<Instruction> code) {
    system.cells = {{.name = "location", .high = 1}, {.name = "x", .high = 9}};
    system.instances.push_back({.name = "P", .locations = {"a", "b"}, .location = 0});
    verify::Nodes nodes(system);
    test = nodes.equal(nodes.cell(1), nodes.number(9));
    division = nodes.binary(verify::NodeOp::Divide, nodes.number(1), nodes.cell(1));
    path.guard = nodes.number(1);
    path.assignments = {{.target = 0, .value = nodes.number(1)}};
    for (auto& instruction : code)
      if (instruction.kind == InstructionKind::JumpUnless) instruction.node = test;
    path.code = std::move(code);
  }

  [[nodiscard]] verify::Path without(std::initializer_list<verify::EventId> asked) const {
    verify::Bits events;
    for (auto event : asked) events.insert(event);
    return verify::withoutIdleTests(system, path, events);
  }

  verify::System system;
  verify::Path path;
  verify::NodeId test = 0;
  verify::NodeId division = 0;
};

Instruction jump(InstructionKind kind, std::uint32_t to) { return {.kind = kind, .last = to}; }
Instruction tag(verify::EventId event) { return {.kind = InstructionKind::Tag, .event = event}; }
Instruction end() { return {.kind = InstructionKind::To, .first = 0, .last = 1}; }

} // namespace

TEST_CASE("a test that decides about nothing but an event is removed unless that is asked for") {
  const Coded code({jump(InstructionKind::JumpUnless, 2), tag(kForbidden), tag(kOther), end()});
  CHECK(code.without({kForbidden}).code.size() == 4);
  const auto without = code.without({kOther});
  REQUIRE(without.code.size() == 2);
  CHECK(without.code[0].event == kOther);
  CHECK_FALSE(without.reads.contains(1));
}

TEST_CASE(
    "a test with an alternative is removed as a whole, and jumps to its end still lead there") {
  const Coded code({jump(InstructionKind::JumpUnless, 6),
                    jump(InstructionKind::JumpUnless, 4),
                    tag(kForbidden),
                    jump(InstructionKind::Jump, 5),
                    tag(kForbidden),
                    {.kind = InstructionKind::Loop},
                    end()});
  const auto without = code.without({});
  REQUIRE(without.code.size() == 3);
  CHECK(without.code[0].last == 2);
  CHECK(without.code[1].kind == InstructionKind::Loop);
  CHECK(without.reads.contains(1)); // the first test decides where the path ends
}

TEST_CASE("a test within another goes with it, or alone") {
  const Coded code({jump(InstructionKind::JumpUnless, 4), tag(kOther),
                    jump(InstructionKind::JumpUnless, 4), tag(kForbidden), end()});
  CHECK(code.without({}).code.size() == 1);
  CHECK(code.without({kOther}).code.size() == 3);
  CHECK(code.without({kForbidden}).code.size() == 5);
}

TEST_CASE("a test stays that may fail, that something is written after, or that others jump into") {
  Coded failing({jump(InstructionKind::JumpUnless, 2), tag(kForbidden), end()});
  failing.path.code[0].node = failing.division;
  CHECK(failing.without({}).code.size() == 3);
  const Coded writing({jump(InstructionKind::JumpUnless, 2),
                       {.kind = InstructionKind::Assign, .first = 0, .last = 1},
                       end()});
  CHECK(writing.without({}).code.size() == 3);
  const Coded entered({jump(InstructionKind::JumpUnless, 3), end(),
                       jump(InstructionKind::JumpUnless, 4), tag(kForbidden), end()});
  CHECK(entered.without({}).code.size() == 5);
  const Coded backwards({tag(kOther), jump(InstructionKind::JumpUnless, 0), end()});
  CHECK(backwards.without({}).code.size() == 3);
}

} // namespace proskill::test::idle_tests_test
