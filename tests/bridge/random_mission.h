#pragma once

#include <cstdint>
#include <string>

namespace proskill::test {

/// A random program with a composite skill `Main` of statements that a tree can say, mostly. Its
/// basic skills are called a0 to a4, its conditions c0 to c2. Every other seed has
/// waits for a time; in every fourth, a4 may be refused.
[[nodiscard]] std::string randomMission(std::uint64_t seed);

} // namespace proskill::test
