#pragma once

#include "fiacre/parse.h"
#include "ide/completion.h"
#include "ide/tokens.h"

namespace proskill::ide {

/// What an editor shows names of Fiacre as.
struct Look {
  TokenType token;
  CompletionKind completion;
};
[[nodiscard]] Look lookOf(fiacre::NameKind kind);

} // namespace proskill::ide
