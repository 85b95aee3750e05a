#pragma once

#include "ide/snapshot/snapshot.h"
#include "lsp/protocol/registry.h"
#include "rpc/json_writer.h"

#include <expected>

/// Converts between bytes in files and the protocol's positions in URIs.
namespace proskill::lsp {

/// Converts places of one program to the protocol's formats. For one thread.
class Converter {
public:
  Converter(const ide::View& view, const Request& request)
      : program(view.program()),
        texts(request.snapshot.open()),
        encoding(request.client.encoding) {}
  Converter(const analysis::Program& program, const ide::OpenTexts& texts,
            syntax::Encoding encoding)
      : program(program), texts(texts), encoding(encoding) {}

  [[nodiscard]] Json position(analysis::FileId file, syntax::Offset at) const;
  [[nodiscard]] Json range(analysis::FileId file, syntax::Range range) const;
  [[nodiscard]] Json range(analysis::Location location) const {
    return range(location.file, location.range);
  }
  [[nodiscard]] Json location(analysis::Location location) const;
  void write(rpc::JsonWriter& json, analysis::FileId file, syntax::Range range) const;
  void write(rpc::JsonWriter& json, analysis::Location location) const;
  /// Whether the client knows this text; it does not know the server's own text of a notebook.
  [[nodiscard]] bool isShown(analysis::FileId file) const;
  /// The client's spelling for texts that it has open.
  [[nodiscard]] std::string uri(analysis::FileId file) const;

private:
  const analysis::Program& program;
  const ide::OpenTexts& texts;
  syntax::Encoding encoding;
  mutable std::uint32_t line = 0; ///< of the last place, since the next one is usually close
};

[[nodiscard]] rpc::RpcError invalidParams(std::string message);
[[nodiscard]] rpc::RpcError requestFailed(std::string message);

/// The path of the text in `textDocument`. A URI with another scheme gets a path that no file has.
[[nodiscard]] std::expected<std::filesystem::path, rpc::RpcError> documentPath(const Json& params);
[[nodiscard]] std::filesystem::path pathOf(std::string_view uri);

/// The URI of a file; the client's spelling if it has the file open.
[[nodiscard]] std::string uriOf(const std::filesystem::path& file, const ide::Snapshot& snapshot);

/// The file of a request by its name in the snapshot; open or not.
[[nodiscard]] std::expected<std::filesystem::path, rpc::RpcError>
documentFile(const Request& request);

/// Parses a list that was written as text if the client wants it in parts.
[[nodiscard]] Json listAnswer(const Request& request, std::string_view list);

/// A member that must be a string.
[[nodiscard]] std::expected<std::string, rpc::RpcError> textIn(const Json& params,
                                                               const char* name);

/// The place in a request.
struct Cursor {
  ide::View view;
  syntax::Offset at = 0;
};

[[nodiscard]] std::expected<ide::View, rpc::RpcError> documentView(const Request& request);
[[nodiscard]] std::expected<Cursor, rpc::RpcError> cursor(const Request& request);
/// A request's `range`.
[[nodiscard]] std::expected<syntax::Range, rpc::RpcError>
rangeIn(const ide::View& view, const Json& params, syntax::Encoding encoding);
[[nodiscard]] std::expected<syntax::Range, rpc::RpcError>
rangeOf(const ide::View& view, const Json& range, syntax::Encoding encoding);
[[nodiscard]] std::expected<syntax::Offset, rpc::RpcError>
offsetOf(const ide::View& view, const Json& position, syntax::Encoding encoding);

} // namespace proskill::lsp
