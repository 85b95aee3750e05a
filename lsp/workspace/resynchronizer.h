#pragma once

#include "lsp/protocol/client.h"
#include "lsp/workspace/workspace.h"
#include "rpc/peer.h"

#include <string>

namespace proskill::lsp {

/// Gets texts again that the server does not know exactly. LSP has no request for a text, but a
/// client with dynamic registration sends the whole text with the next edit if the server registers
/// for that; with others, the user has to reopen the document. For the main thread.
class Resynchronizer {
public:
  /// The arguments outlive it.
  Resynchronizer(rpc::Peer& peer, const ClientFeatures& client) : peer(peer), client(client) {}

  /// Compares with what was inexact before: registers or unregisters for whole texts, and pushes
  /// the diagnostic of lost texts to clients that do not pull.
  void update(const InexactTexts& now);
  /// What makes a lost text known again, as the end of a sentence for the user.
  [[nodiscard]] const char* remedy(const InexactText& lost) const;
  [[nodiscard]] std::string explanation(const InexactText& lost) const;
  /// The only diagnostics of a lost text.
  [[nodiscard]] Json diagnostics(const InexactText& lost) const;

private:
  void askForWholeTexts(bool wanted);

  rpc::Peer& peer;
  const ClientFeatures& client;
  InexactTexts last;
  bool isAsking = false;
};

} // namespace proskill::lsp
