// A form whose `)` is missing ends where the next definition starts a line, so that the damage stays
// in the form. The scanner keeps no state: a tree depends on the text alone.

#include "tree_sitter/parser.h"

#include <string.h>

enum Token { IMPLICIT_CLOSE, ERROR_SENTINEL };

static const char *const kHeads[] = {
    "defconst",    "defsv",       "defevent",       "defskill",
    "defresource", "defproperty", "defenvironment", "defplatform",
    "include",
};

void *tree_sitter_proskill_external_scanner_create(void) { return NULL; }

void tree_sitter_proskill_external_scanner_destroy(void *payload) { (void)payload; }

unsigned tree_sitter_proskill_external_scanner_serialize(void *payload, char *buffer) {
  (void)payload;
  (void)buffer;
  return 0;
}

void tree_sitter_proskill_external_scanner_deserialize(void *payload, const char *buffer,
                                                       unsigned length) {
  (void)payload;
  (void)buffer;
  (void)length;
}

static bool isWordCharacter(int32_t c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

static bool isSpace(int32_t c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

static bool startsDefinition(TSLexer *lexer) {
  char word[16];
  size_t length = 0;
  lexer->advance(lexer, false);
  while (isWordCharacter(lexer->lookahead) && length + 1 < sizeof word) {
    word[length++] = (char)lexer->lookahead;
    lexer->advance(lexer, false);
  }
  if (isWordCharacter(lexer->lookahead)) return false;
  word[length] = '\0';
  for (size_t i = 0; i < sizeof kHeads / sizeof *kHeads; ++i)
    if (strcmp(word, kHeads[i]) == 0) return true;
  return false;
}

bool tree_sitter_proskill_external_scanner_scan(void *payload, TSLexer *lexer,
                                                const bool *valid) {
  (void)payload;
  if (valid[ERROR_SENTINEL] || !valid[IMPLICIT_CLOSE]) return false;
  lexer->mark_end(lexer);
  lexer->result_symbol = IMPLICIT_CLOSE;
  bool lineStart = false;
  while (isSpace(lexer->lookahead)) {
    lineStart = lexer->lookahead == '\n';
    lexer->advance(lexer, true);
  }
  if (lexer->eof(lexer)) return true;
  return lineStart && lexer->lookahead == '(' && startsDefinition(lexer);
}
