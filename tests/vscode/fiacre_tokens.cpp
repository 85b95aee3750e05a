/// Prints the tokens of Fiacre's lexer: `first-byte end-byte kind` for each; without a file, the
/// reserved words. Used to test that the TextMate grammar agrees.

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

#include "fiacre/syntax/lexer.h"
#include "fiacre/syntax/words.h"

namespace {

using namespace proskill::fiacre;

std::string read(const char* path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string_view kindOf(const Token& token) {
  switch (token.kind) {
  case TokenKind::Name: return isReserved(token.text) ? "reserved" : "name";
  case TokenKind::Number: return "number";
  case TokenKind::String: return "string";
  case TokenKind::Symbol: return "symbol";
  case TokenKind::Comment: return "comment";
  case TokenKind::End: return "end";
  }
  return "";
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2)
    for (const auto& word : reservedWords()) std::cout << word << '\n';
  for (int i = 1; i < argc; ++i) {
    const auto text = read(argv[i]);
    for (const auto& token : tokenizeWithComments(text))
      if (token.kind != TokenKind::End)
        std::cout << token.begin << ' ' << token.end() << ' ' << kindOf(token) << '\n';
  }
}
