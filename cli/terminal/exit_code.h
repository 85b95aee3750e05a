#pragma once

namespace proskill::cli {

/// Exit codes. Each command's `--help` says what they mean for it.
enum ExitCode {
  kDone = 0,
  kFound = 1,          ///< the command found something: errors, violations, unformatted files
  kAbandoned = 1,      ///< a client disconnected without notice
  kFailed = 2,         ///< the command line, a file or the program is invalid
  kInconclusive = 3,   ///< a limit was reached before the answer
  kDiffer = 4,         ///< two backends disagree
  kInternalError = 70, ///< EX_SOFTWARE of sysexits.h: a bug of this program
  kOutOfMemory = 71,   ///< EX_OSERR
};

} // namespace proskill::cli
