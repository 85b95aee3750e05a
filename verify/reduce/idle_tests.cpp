#include "verify/reduce/idle_tests.h"

#include "verify/model/path_summary.h"
#include "verify/model/value_bounds.h"

#include <algorithm>
#include <optional>

namespace proskill::verify {

namespace {

bool isJump(const Instruction& it) {
  return it.kind == InstructionKind::JumpUnless || it.kind == InstructionKind::Jump;
}

/// What follows a test until all ways from it meet again, if nothing but events happens there.
std::optional<IdleTest> idleTestAt(const System& system, const Path& path, std::size_t first) {
  IdleTest made{first, first + 1, {}};
  for (std::size_t i = first; i < made.last; ++i) {
    if (i >= path.code.size()) return std::nullopt;
    const Instruction& next = path.code[i];
    if (next.kind == InstructionKind::Tag && next.event != kNone) made.events.insert(next.event);
    if (next.kind == InstructionKind::Tag || next.kind == InstructionKind::Origin) continue;
    if (!isJump(next) || next.last <= i) return std::nullopt;
    if (next.kind == InstructionKind::JumpUnless && mayFail(system, next.node)) return std::nullopt;
    made.last = std::max<std::size_t>(made.last, next.last);
  }
  return made;
}

/// Whether the code jumps from outside into the middle of the test.
bool isEnteredBeside(const Path& path, const IdleTest& test) {
  for (std::size_t i = 0; i < path.code.size(); ++i)
    if ((i < test.first || i >= test.last) && isJump(path.code[i]) &&
        path.code[i].last > test.first && path.code[i].last < test.last)
      return true;
  return false;
}

/// Removes instructions of the code. Jumps to one of them lead to what follows them.
void remove(std::size_t first, std::size_t last, std::vector<Instruction>& code) {
  code.erase(code.begin() + static_cast<std::ptrdiff_t>(first),
             code.begin() + static_cast<std::ptrdiff_t>(last));
  for (auto& instruction : code)
    if (isJump(instruction) && instruction.last > first)
      instruction.last -=
          static_cast<std::uint32_t>(std::min<std::size_t>(instruction.last, last) - first);
}

} // namespace

std::vector<IdleTest> idleTests(const System& system, const Path& path) {
  std::vector<IdleTest> found;
  for (std::size_t i = 0; i < path.code.size(); ++i) {
    if (path.code[i].kind != InstructionKind::JumpUnless) continue;
    auto test = idleTestAt(system, path, i);
    if (test && !isEnteredBeside(path, *test)) found.push_back(std::move(*test));
  }
  return found;
}

Path withoutIdleTests(const System& system, Path path, const Bits& events) {
  auto tests = idleTests(system, path);
  std::erase_if(tests, [&](const IdleTest& test) { return test.events.meets(events); });
  if (tests.empty()) return path;
  std::size_t end = 0; // tests within another one are removed with it
  std::erase_if(tests, [&](const IdleTest& test) {
    const bool isInside = test.last <= end;
    if (!isInside) end = test.last;
    return isInside;
  });
  for (; !tests.empty(); tests.pop_back()) remove(tests.back().first, tests.back().last, path.code);
  for (auto* cells : {&path.guardReads, &path.reads, &path.writes}) *cells = {};
  summarisePath(system, path);
  return path;
}

System withoutIdleTests(System system, const Bits& events) {
  for (auto& path : system.paths) path = withoutIdleTests(system, std::move(path), events);
  for (auto& transition : system.transitions) {
    transition.reads = {};
    for (auto part : transition.parts) transition.reads |= system.paths[part].reads;
  }
  return system;
}

} // namespace proskill::verify
