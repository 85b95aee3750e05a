#pragma once

#include "ide/description/markup.h"
#include "syntax/text/source.h"

namespace proskill::ide {

struct Hover {
  Markup text;
  syntax::Range range; ///< of the word that it describes
};

} // namespace proskill::ide
