#include "syntax/tree/words.h"

#include "syntax/diagnostics/codes.h"
#include "syntax/text/utf8.h"
#include "syntax/tree/build.h"

#include <algorithm>

namespace proskill::syntax {
namespace {

std::string_view rest(std::string_view text, std::size_t at) { return text.substr(at); }

bool isControl(char c) {
  auto code = static_cast<unsigned char>(c);
  return (code < 0x20 && !(code >= '\t' && code <= '\r')) || code == 0x7f;
}

void checkEscape(Builder& builder, const Node& escape) {
  auto text = builder.textOf(escape);
  if (text != "\\\"" && text != "\\\\" && text != "\\n" && text != "\\t")
    builder.report(Code::UnknownEscape, escape.range, text);
}

void checkName(Builder& builder, const Node& name) {
  std::string recovered(builder.textOf(name));
  auto& diagnostic = builder.report(Code::MalformedName, name.range, recovered);
  for (char& c : recovered)
    if (c == '-') c = '_';
  bool ascii =
      std::ranges::all_of(recovered, [](char c) { return static_cast<signed char>(c) > 0; });
  if (ascii && (recovered[0] < '0' || recovered[0] > '9'))
    diagnostic.fixes.push_back(
        {fmt::format("write `{}`", shortened(recovered)), {0, name.range}, recovered});
}

} // namespace

void cleanBytes(std::string& text, std::vector<Diagnostic>& diagnostics) {
  Builder builder{text, diagnostics};
  for (std::size_t at = 0; at < text.size();) {
    std::size_t length = sequenceLength(rest(text, at));
    if (length > 0 && !isControl(text[at])) {
      at += length;
      continue;
    }
    std::size_t end = at + 1;
    if (length > 0) {
      builder.report(Code::ControlCharacter, {static_cast<Offset>(at), static_cast<Offset>(end)},
                     fmt::format("U+{:04X}", static_cast<unsigned char>(text[at])));
    } else {
      while (end < text.size() && sequenceLength(rest(text, end)) == 0) ++end;
      builder.report(Code::InvalidUtf8, {static_cast<Offset>(at), static_cast<Offset>(end)});
    }
    while (at < end) text[at++] = kNoText;
  }
}

void checkWords(std::string_view text, const Tree& tree, std::vector<Diagnostic>& diagnostics) {
  Builder builder{text, diagnostics};
  for (const Node& node : tree) {
    auto word = builder.textOf(node);
    switch (node.kind) {
    case NodeKind::EscapeSequence: checkEscape(builder, node); break;
    case NodeKind::MalformedName: checkName(builder, node); break;
    case NodeKind::Number:
      if (!parseRational(word)) builder.report(Code::NumberTooLarge, node.range, word);
      break;
    case NodeKind::Unexpected:
      if (word.front() != kNoText) builder.report(Code::UnexpectedCharacter, node.range, word);
      break;
    case NodeKind::Error: builder.report(Code::UnexpectedCharacter, node.range, "..."); break;
    default: break;
    }
  }
}

} // namespace proskill::syntax
