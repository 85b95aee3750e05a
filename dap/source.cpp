#include "dap/source.h"

#include "ide/verdicts/simulated_run.h"

#include <algorithm>

namespace proskill::dap {

namespace {

class Recorded : public StepSource {
public:
  explicit Recorded(Trace of) : whole(std::move(of)) {}

  [[nodiscard]] const Trace& trace() const override { return whole; }
  [[nodiscard]] bool isSimulation() const override { return false; }
  [[nodiscard]] std::vector<Step> choices() const override {
    if (position == whole.steps.size()) return {};
    return {whole.steps[position]};
  }
  void take(std::size_t) override { ++position; }
  void undo() override { --position; }
  [[nodiscard]] bool hasLine(const std::filesystem::path& path, unsigned line) const override {
    return std::ranges::any_of(whole.steps, [&](const Step& step) {
      return step.place && step.place->line == line && step.place->path == path;
    });
  }

private:
  Trace whole;
  std::size_t position = 0;
};

class Simulated : public StepSource {
public:
  Simulated(std::unique_ptr<const analysis::Program> of, ide::SimulatedRun started)
      : program(std::move(of)), run(std::move(started)) {
    whole.initial = run.trace().initial;
    for (const auto& file : program->files) paths.push_back(oneSpelling(file.path));
  }

  [[nodiscard]] const Trace& trace() const override { return whole; }
  [[nodiscard]] bool isSimulation() const override { return true; }

  [[nodiscard]] std::vector<Step> choices() const override {
    const ide::Trace all{{}, run.choices()};
    auto read = readTrace(report::traceJson(*program, all), {});
    return read ? std::move(read->steps) : std::vector<Step>();
  }

  void take(std::size_t choice) override { run.take(choice); }
  void undo() override { run.undo(); }

  [[nodiscard]] bool hasLine(const std::filesystem::path& path, unsigned line) const override {
    return std::ranges::any_of(run.of().provenance.origins, [&](const fiacre::Origin& origin) {
      if (origin.begin == origin.end || origin.description.empty() || paths[origin.file] != path)
        return false;
      return program->files[origin.file].document.lines().position(origin.begin).line + 1 == line;
    });
  }

private:
  std::unique_ptr<const analysis::Program> program;
  ide::SimulatedRun run;
  Trace whole;
  std::vector<std::filesystem::path> paths; ///< by file, canonical
};

} // namespace

std::unique_ptr<StepSource> recorded(Trace trace) {
  return std::make_unique<Recorded>(std::move(trace));
}

std::expected<std::unique_ptr<StepSource>, std::string> simulated(analysis::Program checked,
                                                                  const std::string& mainSkill) {
  auto program = std::make_unique<const analysis::Program>(std::move(checked));
  codegen::Options options;
  options.mainSkill = mainSkill;
  auto made = codegen::generate(*program, options);
  if (!made) return std::unexpected(made.error().message);
  auto run = ide::SimulatedRun::start(std::move(*made));
  if (!run) return std::unexpected(run.error());
  return std::make_unique<Simulated>(std::move(program), std::move(*run));
}

} // namespace proskill::dap
