#pragma once

#include "fiacre/syntax/parse.h"
#include "ide/completion/completion.h"
#include "ide/features/tokens.h"

namespace proskill::ide {

/// What an editor shows names of Fiacre as.
struct Look {
  TokenType token;
  CompletionKind completion;
};
[[nodiscard]] Look lookOf(fiacre::NameKind kind);

} // namespace proskill::ide
