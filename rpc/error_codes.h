// Made by tests/lsp/conformance/numbers.mjs from npm's vscode-languageserver-protocol.
#pragma once

namespace proskill::rpc {

/// Error codes of JSON-RPC and of the language server protocol.
enum class ErrorCode : int {
  ParseError = -32700,
  InternalError = -32603,
  InvalidParams = -32602,
  MethodNotFound = -32601,
  InvalidRequest = -32600,
  MessageWriteError = -32099,
  MessageReadError = -32098,
  PendingResponseRejected = -32097,
  ConnectionInactive = -32096,
  ServerNotInitialized = -32002,
  UnknownErrorCode = -32001,
  RequestFailed = -32803,
  ServerCancelled = -32802,
  ContentModified = -32801,
  RequestCancelled = -32800,
};

} // namespace proskill::rpc
