#pragma once

#include "rpc/rpc.h"
#include "syntax/document.h"
#include "syntax/text/position.h"

#include <map>
#include <string>

namespace proskill::test {

/// Converts the protocol's positions in answers to bytes. Throws `std::runtime_error` for an
/// invalid one: outside of the text, or within a character.
class BytePlaces {
public:
  /// \param documents by their URIs; outlives this
  BytePlaces(const std::map<std::string, syntax::Document>& documents, syntax::Encoding encoding)
      : documents(documents), encoding(encoding) {}

  /// \param uri default text that positions refer to
  [[nodiscard]] Json convert(const Json& answer, const std::string& uri) const;
  /// For `semanticTokens`: each as begin, end, type and modifiers.
  [[nodiscard]] Json convertTokens(const Json& data, const std::string& uri) const;

private:
  [[nodiscard]] Json convertObject(const Json& object, const std::string& uri) const;
  [[nodiscard]] syntax::Offset byteOf(syntax::EditorPosition position,
                                      const std::string& uri) const;

  const std::map<std::string, syntax::Document>& documents;
  syntax::Encoding encoding;
};

} // namespace proskill::test
