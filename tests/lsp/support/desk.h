#pragma once

#include "lsp/protocol/registry.h"
#include "syntax/text/edit.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::test {

/// Programs as an editor has them open, asked through the server's own handlers, without streams
/// and threads. Answers have bytes of the texts where the protocol has positions, so that they are
/// the same in every encoding.
class Desk {
public:
  /// \param files texts by their names, all of them open
  Desk(const std::map<std::string, std::string>& files, syntax::Encoding encoding);

  /// The methods that are asked about a place, those about a document, and those about all.
  [[nodiscard]] std::vector<std::string> methodsOfPlaces() const;
  [[nodiscard]] std::vector<std::string> methodsOfDocuments() const;
  [[nodiscard]] std::vector<std::string> methodsOfWorkspaces() const;

  /// An error is `{"error": message}`. What must not be is thrown as `std::runtime_error`: a bug of
  /// the handler, a place outside of its text or within a character, an empty range upside down.
  [[nodiscard]] Json ask(const std::string& method, const std::string& file,
                         syntax::Offset at) const;
  /// What an editor asks next of such an answer, as what `resolve` says of its items; each with its
  /// method before it.
  [[nodiscard]] std::vector<std::pair<std::string, Json>>
  followUps(const std::string& method, const std::string& file, syntax::Offset at) const;

  /// The answer as it is sent. \param more members of the request beside the usual ones
  [[nodiscard]] Json answer(const std::string& method, const std::string& file,
                            const Json& more = Json::object()) const;
  /// The items of an answer that is a list, as they are where the client takes lists in parts.
  [[nodiscard]] Json inParts(const std::string& method, const std::string& file) const;

  [[nodiscard]] const std::string& text(const std::string& file) const;
  void edit(const std::string& file, const syntax::TextEdit& edit);

private:
  [[nodiscard]] Json raw(const std::string& method, const Json& params) const;
  [[nodiscard]] Json params(const std::string& method, const std::string& file,
                            syntax::Offset at) const;
  [[nodiscard]] Json inBytes(const std::string& method, const Json& answer,
                             const std::string& uri) const;

  lsp::Registry registry = lsp::allFeatures();
  lsp::ClientFeatures client;
  std::map<std::string, syntax::Document> documents; ///< by their URIs
  std::shared_ptr<const ide::Snapshot> snapshot;
};

} // namespace proskill::test
