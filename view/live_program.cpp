#include "codegen/model.h"
#include "disk/disk.h"
#include "ide/snapshot/fiacre_file.h"
#include "report/simulation_json.h"
#include "report/text/source_place.h"
#include "report/verify_report.h"
#include "verify/answer_store.h"
#include "view/panel_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

namespace proskill::view {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kBetweenLooks{250};

/// A program and its source. Immutable.
struct Loaded {
  analysis::Program program;
  std::optional<codegen::Model> model; ///< of a Fiacre model; otherwise generated on demand
  std::string error;                   ///< the first error; empty if there is none
  std::vector<std::pair<fs::path, fs::file_time_type>> stamps;
};

fs::file_time_type stampOf(const fs::path& path) {
  std::error_code error;
  const auto time = fs::last_write_time(path, error);
  return error ? fs::file_time_type::min() : time;
}

/// Its path is short, since little of the message can be seen in a small window.
std::string firstError(const analysis::Program& program,
                       const std::vector<syntax::Diagnostic>& diagnostics) {
  for (const auto& found : diagnostics) {
    if (found.severity != syntax::Severity::Error) continue;
    const auto folder = program.files.front().path.parent_path();
    const auto path = program.files[found.location.file].path.lexically_relative(folder);
    return fmt::format("{}:{}: {}", path.generic_string(),
                       report::SourcePlaces(program).begin(found.location).line, found.message);
  }
  return "";
}

std::shared_ptr<const Loaded> load(const std::string& file) {
  auto loaded = std::make_shared<Loaded>();
  const disk::DiskFileSystem disk;
  // taken before the texts are read, so that writes in between count as changes
  const auto before = stampOf(file);
  if (ide::isFiacre(file)) {
    auto read = ide::readFiacre(file, disk.read(file).value_or(""));
    loaded->program = std::move(read.program);
    loaded->model = std::move(read.model);
    loaded->error = firstError(loaded->program, read.diagnostics);
  } else {
    loaded->program = analysis::load(disk, file);
    loaded->error = firstError(loaded->program, analysis::check(loaded->program));
  }
  for (const auto& read : loaded->program.files)
    loaded->stamps.emplace_back(read.path, stampOf(read.path));
  loaded->stamps.front().second = before;
  return loaded;
}

bool hasChanged(const Loaded& loaded) {
  return std::ranges::any_of(
      loaded.stamps, [](const auto& stamp) { return stampOf(stamp.first) != stamp.second; });
}

/// A program that was verified, and the answers, from which traces are built when somebody wants to
/// see them.
struct Verified {
  std::shared_ptr<const Loaded> loaded;
  codegen::Model model;
  verify::AnswersInMemory answers;
  std::mutex mutex; ///< guards the answers
};

class LiveProgram : public PanelData {
public:
  LiveProgram(ViewOptions chosen, EventFeed& board)
      : options(std::move(chosen)),
        news(board),
        loaded(load(options.file)),
        worker([this] { work(); }) {}

  ~LiveProgram() override {
    stopped = true;
    cancelled = true;
    wake.notify_all();
    worker.join();
  }

  OrderedJson program() override {
    const std::lock_guard lock(mutex);
    OrderedJson json = report.is_null() ? empty() : report;
    json["main"] = mainSkill();
    json["label"] = fs::path(options.file).filename().generic_string();
    json["state"] = state;
    json["stale"] = stale;
    json["message"] = message;
    json["progress"] = progress;
    json["pictures"] = picturesJson(loaded->program);
    json["files"] = filesJson(loaded->program);
    return json;
  }

  Answer trace(const std::string& name) override {
    std::shared_ptr<Verified> of;
    {
      const std::lock_guard lock(mutex);
      if (const auto found = traces.find(name); found != traces.end()) return found->second;
      of = verified;
    }
    if (of)
      if (auto found = findTrace(*of, name)) return *std::move(found);
    return std::unexpected("this property has no trace");
  }

  Answer picture(const PictureParams& params) override {
    const auto now = current();
    return pictureJson(now->program, params, !now->error.empty());
  }

  /// With the text that was verified, if it is another one: traces have its places.
  Answer source(const std::string& uri) override {
    std::unique_lock lock(mutex);
    const auto now = loaded;
    const auto then = verified ? verified->loaded : loaded;
    lock.unlock();
    auto found = sourceJson(now->program, uri);
    const auto older = sourceJson(then->program, uri);
    if (found && older && older->at("text") != found->at("text"))
      (*found)["verified"] = older->at("text");
    return found;
  }

  Answer simulate(const OrderedJson& params) override {
    const auto asked = report::readChosenRun(params);
    if (!asked) return std::unexpected(asked.error());
    const auto now = current();
    if (!now->error.empty()) return std::unexpected("the program has errors: " + now->error);
    const std::lock_guard lock(simulating);
    if (auto failed = begin(now); !failed.empty()) return std::unexpected(failed);
    const auto missing = simulated->run.follow(asked->steps);
    return report::simulationJson(now->program, simulated->run, *asked, missing);
  }

  [[nodiscard]] bool canSimulate() const override { return !ide::isFiacre(options.file); }

  void verify() override {
    asked = true;
    cancelled = true;
    wake.notify_all();
  }

  [[nodiscard]] bool canVerify() const override { return true; }

private:
  /// A simulation of a loaded program; it is valid while the text is unchanged.
  struct Simulated {
    std::shared_ptr<const Loaded> loaded;
    ide::SimulatedRun run;
  };

  /// \return why the program cannot be simulated; empty on success
  /// \pre `simulating` is held
  std::string begin(const std::shared_ptr<const Loaded>& now) {
    if (simulated && simulated->loaded == now) return "";
    auto model = modelOf(*now);
    if (!model) return model.error().message;
    auto run = ide::SimulatedRun::start(std::move(*model));
    if (!run) return run.error();
    simulated.emplace(now, std::move(*run));
    return "";
  }

  std::shared_ptr<const Loaded> current() {
    const std::lock_guard lock(mutex);
    return loaded;
  }

  [[nodiscard]] OrderedJson empty() const {
    return {{"version", 1},
            {"program", fs::path(options.file).generic_string()},
            {"properties", OrderedJson::array()},
            {"exploration", nullptr}};
  }

  [[nodiscard]] OrderedJson mainSkill() const {
    if (!options.mainSkill.empty()) return options.mainSkill;
    const auto* skill = analysis::mainSkill(loaded->program).skill;
    return skill ? OrderedJson(skill->name()) : OrderedJson();
  }

  void work() {
    while (!stopped) {
      cancelled = false;
      asked = false;
      verifyOnce(current());
      waitForChange();
      if (stopped) return;
      auto fresh = load(options.file);
      {
        const std::lock_guard lock(mutex);
        loaded = std::move(fresh);
        stale = !report.is_null();
      }
      news.announce("edited", OrderedJson::object());
    }
  }

  void waitForChange() {
    while (!stopped && !asked && !hasChanged(*current())) {
      std::unique_lock lock(mutex);
      wake.wait_for(lock, kBetweenLooks, [this] { return stopped || asked; });
    }
  }

  void set(std::string now, std::string words, OrderedJson much = nullptr) {
    {
      const std::lock_guard lock(mutex);
      state = std::move(now);
      message = std::move(words);
      progress = std::move(much);
    }
    news.announce("program", program());
  }

  void verifyOnce(const std::shared_ptr<const Loaded>& now) {
    if (!now->error.empty()) return set("errors", now->error);
    auto model = modelOf(*now);
    if (!model) return set("errors", model.error().message);
    set("checking", "");
    const auto next = std::make_shared<Verified>(now, std::move(*model));
    auto engine = engineFor(now, next->model.checks.size());
    engine.answers = &next->answers;
    const auto result = ide::verifyModel(next->model, {}, engine, {}, ide::kTracesOfEditor);
    if (!result) return set("failed", "this model cannot be explored: " + result.error().message);
    if (cancelled) return; // a newer verification follows
    take(report::reportJson({now->program, next->model, *result, next->model.mainSkill}), next);
    set("done", "");
  }

  [[nodiscard]] std::expected<codegen::Model, codegen::GenerationError>
  modelOf(const Loaded& now) const {
    if (now.model) return *now.model;
    codegen::Options choice;
    choice.mainSkill = options.mainSkill;
    return codegen::generate(now.program, choice);
  }

  verify::Options engineFor(const std::shared_ptr<const Loaded>& now, std::size_t total) {
    verify::Options engine;
    engine.limits = options.limits;
    engine.cancelled = &cancelled;
    engine.progress = [this, now, total](const verify::Progress& seen) {
      if (hasChanged(*now)) cancelled = true;
      const double rate = seen.seconds > 0 ? static_cast<double>(seen.classes) / seen.seconds : 0;
      set("checking", "",
          {{"decided", seen.decided},
           {"total", total},
           {"classes", seen.classes},
           {"rate", rate},
           {"bytes", seen.bytes},
           {"seconds", seen.seconds}});
    };
    return engine;
  }

  /// The trace of a property as the page gets it.
  static OrderedJson traceOf(const OrderedJson& property, const OrderedJson& trace) {
    OrderedJson json{{"name", property["name"]},
                     {"description", property["description"]},
                     {"verdict", property["verdict"]}};
    json.update(trace);
    return json;
  }

  /// Builds a trace that was not wanted when the program was verified.
  std::optional<OrderedJson> findTrace(Verified& of, const std::string& name) {
    const std::lock_guard lock(of.mutex);
    verify::Options engine;
    engine.limits = options.limits;
    engine.cancelled = &stopped;
    engine.answers = &of.answers;
    const auto result = ide::verifyModel(of.model, {name}, engine);
    if (!result) return std::nullopt;
    for (const auto& row : result->rows) {
      if (row.check->name != name || !row.trace) continue;
      const auto property = report::propertyJson(of.loaded->program, row);
      return traceOf(property, property["trace"]);
    }
    return std::nullopt;
  }

  /// Stores a report. Traces are large, so pages request them one by one.
  void take(OrderedJson whole, std::shared_ptr<Verified> of) {
    std::map<std::string, OrderedJson> apart;
    for (auto& property : whole["properties"]) {
      const auto trace = std::exchange(property["trace"], nullptr);
      if (!trace.is_null()) apart[property["name"].get<std::string>()] = traceOf(property, trace);
    }
    const std::lock_guard lock(mutex);
    report = std::move(whole);
    traces = std::move(apart);
    verified = std::move(of);
    stale = false;
  }

  ViewOptions options;
  EventFeed& news;
  std::mutex simulating; ///< guards the simulation
  std::optional<Simulated> simulated;
  std::mutex mutex; ///< guards the members up to `progress`
  std::shared_ptr<const Loaded> loaded;
  OrderedJson report;                        ///< the latest; null if there is none yet
  std::map<std::string, OrderedJson> traces; ///< those that were built with the report
  std::shared_ptr<Verified> verified;        ///< null if there is no report yet
  bool stale = false;
  std::string state = "checking";
  std::string message;
  OrderedJson progress;
  std::condition_variable wake;
  std::atomic<bool> stopped{false};
  std::atomic<bool> asked{false};
  std::atomic<bool> cancelled{false};
  std::thread worker; ///< declared last, since it uses the other members
};

} // namespace

std::unique_ptr<PanelData> liveProgram(ViewOptions options, EventFeed& news) {
  return std::make_unique<LiveProgram>(std::move(options), news);
}

} // namespace proskill::view
