#pragma once

#include "lsp/protocol/registry.h"
#include "syntax/text/edit.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::test {

/// Programs that are open in an editor, with requests directly to the server's handlers, without
/// streams and threads. Positions in answers are converted to bytes, so that they are the same in
/// every encoding.
class Desk {
public:
  /// \param files texts by their names, all of them open
  Desk(const std::map<std::string, std::string>& files, syntax::Encoding encoding);

  /// The methods with a position, with a document, and without either.
  [[nodiscard]] std::vector<std::string> methodsOfPlaces() const;
  [[nodiscard]] std::vector<std::string> methodsOfDocuments() const;
  [[nodiscard]] std::vector<std::string> methodsOfWorkspaces() const;

  /// An error is `{"error": message}`. Throws `std::runtime_error` for invalid answers: an
  /// exception in the handler, a position outside of its text or within a character, a reversed
  /// range.
  [[nodiscard]] Json ask(const std::string& method, const std::string& file,
                         syntax::Offset at) const;
  /// The requests that an editor sends after such an answer, such as `resolve` for its items, with
  /// their methods.
  [[nodiscard]] std::vector<std::pair<std::string, Json>>
  followUps(const std::string& method, const std::string& file, syntax::Offset at) const;

  /// The answer as it is sent. \param more members of the request beside the usual ones
  [[nodiscard]] Json answer(const std::string& method, const std::string& file,
                            const Json& more = Json::object()) const;
  /// The items of an answer that is a list, unchanged if the client accepts partial results.
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
  std::map<std::string, syntax::Document> documents; ///< by URI
  std::shared_ptr<const ide::Snapshot> snapshot;
};

} // namespace proskill::test
