#include "codegen/model.h"
#include "ide/snapshot/fiacre_file.h"
#include "lsp/protocol/convert.h"
#include "lsp/verification/verdict_json.h"
#include "report/simulation_json.h"

#include <fmt/format.h>

#include <deque>
#include <mutex>

/// `proskill/simulate`: a run whose steps the client chooses. The steps are stored in the client;
/// the server caches recent runs to avoid replaying them.
namespace proskill::lsp {

namespace {

std::expected<ide::SimulatedRun, std::string> begin(const ide::View& view,
                                                    const std::string& mainSkill) {
  if (ide::isFiacre(view)) return std::unexpected("only programs can be simulated");
  for (const auto& diagnostic : view.analysis().diagnostics)
    if (diagnostic.severity == syntax::Severity::Error)
      return std::unexpected("the program has errors: " + diagnostic.message);
  codegen::Options options;
  options.mainSkill = mainSkill;
  auto model = codegen::generate(view.program(), options);
  if (!model) return std::unexpected(model.error().message);
  return ide::SimulatedRun::start(std::move(*model));
}

/// Cache of recent runs, by program. Thread-safe.
class Runs {
public:
  Answer simulate(const Request& request) {
    const auto path = documentFile(request);
    if (!path) return std::unexpected(path.error());
    const auto asked = report::readChosenRun(OrderedJson(request.params));
    if (!asked) return std::unexpected(invalidParams(asked.error()));
    const auto view = request.snapshot.view(*path);
    const std::lock_guard lock(mutex);
    auto run = runOf(view, asked->mainSkill);
    if (!run) return std::unexpected(requestFailed(run.error()));
    const auto missing = (*run)->follow(asked->steps);
    return toClient(report::simulationJson(view.program(), **run, *asked, missing), view, request);
  }

private:
  struct Known {
    std::weak_ptr<const ide::AnalysedProgram> program;
    std::string mainSkill; ///< as requested
    ide::SimulatedRun run;
  };

  std::expected<ide::SimulatedRun*, std::string> runOf(const ide::View& view,
                                                       const std::string& mainSkill) {
    constexpr std::size_t kMost = 2;
    std::erase_if(known, [](const Known& it) { return it.program.expired(); });
    for (auto& it : known)
      if (it.program.lock() == view.owner && it.mainSkill == mainSkill) return &it.run;
    auto started = begin(view, mainSkill);
    if (!started) return std::unexpected(started.error());
    if (known.size() == kMost) known.pop_front();
    return &known.emplace_back(view.owner, mainSkill, std::move(*started)).run;
  }

  static Json toClient(const OrderedJson& made, const ide::View& view, const Request& request) {
    const Converter convert(view, request);
    const auto& program = view.program();
    const auto& trace = made.at("trace");
    Json steps = stepsJson(program, trace.at("steps"), convert);
    for (std::size_t i = 0; i < steps.size(); ++i)
      if (trace["steps"][i].contains("late")) steps[i]["late"] = true;
    return {{"program", convert.uri(0)},
            {"main", made.at("main")},
            {"trace",
             {{"name", trace.at("name")},
              {"description", trace.at("description")},
              {"verdict", trace.at("verdict")},
              {"initial", trace.at("initial")},
              {"variables", variablesJson(program, trace.at("initial"))},
              {"actors", actorsJson(program, trace.at("steps"))},
              {"steps", std::move(steps)}}},
            {"choices", stepsJson(program, made.at("choices"), convert)},
            {"missing", made.at("missing")},
            {"unmet", made.at("unmet")},
            {"texts", textsJson(program, request.snapshot.open())}};
  }

  std::mutex mutex;
  std::deque<Known> known;
};

} // namespace

void addSimulation(Registry& registry) {
  registry.add(
      "proskill/simulate",
      [runs = std::make_shared<Runs>()](const Request& request) { return runs->simulate(request); },
      rpc::Priority::Background);
}

} // namespace proskill::lsp
