#pragma once

#include "worker/worker_job.h"

#include <chrono>

namespace proskill::lsp {

/// The names of the settings that raise the limits of a verification; empty: none does.
struct LimitSettings {
  std::string_view seconds;
  std::string_view megabytes;
};
inline constexpr LimitSettings kLiveLimits{"verify.seconds", "verify.megabytes"};
inline constexpr LimitSettings kRequestLimits{"verify.requestSeconds", "verify.requestMegabytes"};

/// Whether and how programs are verified. docs/lsp.md has the names and the defaults.
struct VerificationSettings {
  bool trusted = true; ///< otherwise nothing is verified, whatever the other settings are
  bool live = true;
  bool durations = true; ///< measure how long skills take, after live verification
  /// The longest pause in editing before live verification starts; see `delayAfter`.
  std::chrono::milliseconds delay{500};
  worker::Budget liveBudget{2, 512, {}};
  worker::Budget requestBudget{60, 2048, {}};
};

/// The pause in editing before live verification starts: half of what the last one took, since an
/// edit that comes too early wastes no more than that.
[[nodiscard]] std::chrono::steady_clock::duration
delayAfter(const VerificationSettings& settings,
           std::optional<std::chrono::steady_clock::duration> took);

/// The settings changed by a `verify` section; absent and invalid values do not change anything.
/// Only the client can set `trusted`; it is not a setting of the workspace.
[[nodiscard]] VerificationSettings withSettings(VerificationSettings settings, const Json& section);

/// The settings in `initializationOptions`.
[[nodiscard]] VerificationSettings initialSettings(const Json& options);

/// The budget with the limits of a request.
[[nodiscard]] worker::Budget withLimits(worker::Budget budget, const Json& limits);

} // namespace proskill::lsp
