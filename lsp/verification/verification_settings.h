#pragma once

#include "worker/worker_job.h"

#include <chrono>

namespace proskill::lsp {

/// The settings that raise the limits of a verification, as users write them; empty: none does.
struct LimitSettings {
  std::string_view seconds;
  std::string_view megabytes;
};
inline constexpr LimitSettings kLiveLimits{"verify.seconds", "verify.megabytes"};
inline constexpr LimitSettings kRequestLimits{"verify.requestSeconds", "verify.requestMegabytes"};

/// Whether and how programs are verified. docs/lsp.md has the names and the defaults.
struct VerificationSettings {
  bool trusted = true; ///< else nothing is verified, whatever else is said
  bool live = true;
  std::chrono::milliseconds delay{500}; ///< without an edit, before live verification begins
  worker::Budget liveBudget{2, 512, {}};
  worker::Budget requestBudget{60, 2048, {}};
};

/// The settings with those that a `verify` section gives; what is absent or has the wrong form
/// stays as it is. `trusted` is the client's word alone, and not a setting of the workspace.
[[nodiscard]] VerificationSettings withSettings(VerificationSettings settings, const Json& section);

/// Those of `initializationOptions`.
[[nodiscard]] VerificationSettings initialSettings(const Json& options);

/// The budget with the limits that a request gives.
[[nodiscard]] worker::Budget withLimits(worker::Budget budget, const Json& limits);

} // namespace proskill::lsp
