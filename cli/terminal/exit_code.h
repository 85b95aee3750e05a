#pragma once

namespace proskill::cli {

/// With what a command ends; its `--help` says what each code means for it.
enum ExitCode {
  kDone = 0,
  kFound = 1,          ///< what the command looks for: errors, violations, files to lay out
  kAbandoned = 1,      ///< a client went away without saying so
  kFailed = 2,         ///< the command line, a file or the program is wrong
  kInconclusive = 3,   ///< a limit was met before the answer
  kDiffer = 4,         ///< two backends disagree
  kInternalError = 70, ///< EX_SOFTWARE of sysexits.h: our mistake, not the user's
  kOutOfMemory = 71,   ///< EX_OSERR
};

} // namespace proskill::cli
