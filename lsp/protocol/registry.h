#pragma once

#include "ide/snapshot/snapshot.h"
#include "ide/verdicts/verdicts.h"
#include "lsp/protocol/client.h"
#include "lsp/protocol/client_settings.h"
#include "lsp/protocol/progress.h"
#include "rpc/rpc.h"
#include "rpc/scheduler.h"

#include <expected>
#include <functional>
#include <map>
#include <string>

namespace proskill::lsp {

/// A request with the input of its handler. Handlers run on any thread, on an immutable snapshot.
struct Request {
  const Json& params;
  const ide::Snapshot& snapshot;
  const ClientFeatures& client;
  rpc::Cancellation cancellation;
  /// The last verdicts of every program; never null.
  std::shared_ptr<const ide::Verdicts> verdicts = std::make_shared<const ide::Verdicts>();
  /// The editor's settings; never null.
  std::shared_ptr<const ClientSettings> settings = std::make_shared<const ClientSettings>();
  /// For long tasks and partial results; never null.
  std::shared_ptr<Progress> progress = std::make_shared<Progress>();
};

using Answer = std::expected<Json, rpc::RpcError>;
using Handler = std::function<Answer(const Request&)>;

struct Method {
  Handler handler;
  rpc::Priority priority = rpc::Priority::Interactive;
};

/// The requests that the server answers, and its capabilities. Each group of
/// features has a file `lsp/features/feature_GROUP.cpp` with one function that adds its methods and
/// its capabilities.
struct Registry {
  std::map<std::string, Method, std::less<>> methods;
  Json capabilities = Json::object();

  void add(std::string method, Handler handler,
           rpc::Priority priority = rpc::Priority::Interactive) {
    methods[std::move(method)] = {std::move(handler), priority};
  }
};

void addAutomaton(Registry& registry);
void addCompletion(Registry& registry);
void addActions(Registry& registry);
void addDiagnostics(Registry& registry);
void addFormatting(Registry& registry);
void addHierarchy(Registry& registry);
void addHints(Registry& registry);
void addHover(Registry& registry);
void addLenses(Registry& registry);
void addModel(Registry& registry);
void addStructure(Registry& registry);
void addTokens(Registry& registry);
void addNavigation(Registry& registry);
void addRecording(Registry& registry);
void addRename(Registry& registry);
void addSimulation(Registry& registry);
void addSymbols(Registry& registry);

[[nodiscard]] Registry allFeatures();

} // namespace proskill::lsp
