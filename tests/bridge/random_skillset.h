#pragma once

#include <cstdint>
#include <string>

namespace proskill::test {

/// A random skillset called `s`, as text. Its resources are `r0` …, its skills `k0` …. Each skill
/// has a success.
[[nodiscard]] std::string randomSkillset(std::uint64_t seed);

} // namespace proskill::test
