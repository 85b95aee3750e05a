#pragma once

#include "fiacre/syntax/parse.h"
#include "ide/answers/token.h"
#include "ide/completion/completion.h"

namespace proskill::ide {

/// How editors show a kind of Fiacre name.
struct Look {
  TokenType token;
  CompletionKind completion;
};
[[nodiscard]] Look lookOf(fiacre::NameKind kind);

} // namespace proskill::ide
