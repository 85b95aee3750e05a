#include "ide/description/explanation.h"

#include <algorithm>
#include <fmt/format.h>

namespace proskill::ide {

std::string titleOf(const syntax::CodeInfo& code) {
  std::string title;
  for (std::size_t i = 0; i < code.message.size(); ++i) {
    const bool hole = code.message.substr(i, 2) == "{}";
    title += hole ? std::string("…") : std::string(1, code.message[i]);
    if (hole) ++i;
  }
  return title;
}

std::string paragraphOf(const syntax::CodeInfo& code) {
  std::string text(code.explanation);
  std::ranges::replace(text, '\n', ' ');
  return text;
}

Markup explanation(const syntax::CodeInfo& code) {
  Markup text;
  text.prose(fmt::format("{}: {}", code.id, titleOf(code)));
  text.prose(paragraphOf(code));
  if (!code.example.empty()) text.code(std::string(code.example));
  return text;
}

} // namespace proskill::ide
