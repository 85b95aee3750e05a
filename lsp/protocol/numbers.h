// Made by tests/lsp/conformance/numbers.mjs from npm's vscode-languageserver-protocol.
#pragma once

/// The enumerations of the language server protocol that are sent as numbers.
namespace proskill::lsp::protocol {

enum class CompletionItemKind : int {
  Text = 1,
  Method = 2,
  Function = 3,
  Constructor = 4,
  Field = 5,
  Variable = 6,
  Class = 7,
  Interface = 8,
  Module = 9,
  Property = 10,
  Unit = 11,
  Value = 12,
  Enum = 13,
  Keyword = 14,
  Snippet = 15,
  Color = 16,
  File = 17,
  Reference = 18,
  Folder = 19,
  EnumMember = 20,
  Constant = 21,
  Struct = 22,
  Event = 23,
  Operator = 24,
  TypeParameter = 25,
};

enum class CompletionItemTag : int {
  Deprecated = 1,
};

enum class DiagnosticSeverity : int {
  Error = 1,
  Warning = 2,
  Information = 3,
  Hint = 4,
};

enum class DiagnosticTag : int {
  Unnecessary = 1,
  Deprecated = 2,
};

enum class DocumentHighlightKind : int {
  Text = 1,
  Read = 2,
  Write = 3,
};

enum class InlayHintKind : int {
  Type = 1,
  Parameter = 2,
};

enum class InsertTextFormat : int {
  PlainText = 1,
  Snippet = 2,
};

enum class InsertTextMode : int {
  AsIs = 1,
  AdjustIndentation = 2,
};

enum class MessageType : int {
  Error = 1,
  Warning = 2,
  Info = 3,
  Log = 4,
  Debug = 5,
};

enum class SymbolKind : int {
  File = 1,
  Module = 2,
  Namespace = 3,
  Package = 4,
  Class = 5,
  Method = 6,
  Property = 7,
  Field = 8,
  Constructor = 9,
  Enum = 10,
  Interface = 11,
  Function = 12,
  Variable = 13,
  Constant = 14,
  String = 15,
  Number = 16,
  Boolean = 17,
  Array = 18,
  Object = 19,
  Key = 20,
  Null = 21,
  EnumMember = 22,
  Struct = 23,
  Event = 24,
  Operator = 25,
  TypeParameter = 26,
};

enum class TextDocumentSyncKind : int {
  None = 0,
  Full = 1,
  Incremental = 2,
};

} // namespace proskill::lsp::protocol
