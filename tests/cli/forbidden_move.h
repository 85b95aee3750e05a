#pragma once

namespace proskill::test {

/// The move from Off to Broken is not allowed.
inline constexpr auto kForbiddenMove =
    R"((defsv lamp :states (Off On Broken) :init Off :transitions ((Off On) (On Broken)))
(defskill kick
  :time_interval [1,2]
  :action (kick)
  :success done (:effects (lamp Broken)))
(defskill mission
  :body ((kick)))
)";

} // namespace proskill::test
