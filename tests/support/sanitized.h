#pragma once

namespace proskill::test {

/// Whether this program runs under the address sanitizer, where everything takes four times as
/// long.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

} // namespace proskill::test
