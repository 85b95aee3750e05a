#include "worker/verify_worker.h"

#include "cache/verdict_cache.h"
#include "codegen/model.h"
#include "ide/snapshot/fiacre_file.h"
#include "ide/verdicts/durations.h"
#include "process/child.h"
#include "process/resource_limit.h"
#include "report/report_json.h"
#include "worker/worker_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <map>
#include <thread>

#include <sys/resource.h>
#include <unistd.h>

namespace proskill::worker {

namespace {

using Clock = std::chrono::steady_clock;

enum ExitCode { kDone = 0, kNoJob = 2, kAlone = 3 };

constexpr rlim_t kMegabyte = rlim_t{1} << 20;

/// Files of a job: exactly its texts, under whatever names they include each other.
class JobFiles : public analysis::FileSystem {
public:
  explicit JobFiles(const std::vector<WorkerText>& all) {
    for (const auto& text : all) texts.emplace(canonical(text.path), &text);
  }

  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const override {
    const auto found = texts.find(canonical(path));
    if (found == texts.end()) return std::unexpected("it is not a file of the program");
    return found->second->text;
  }
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override {
    std::error_code error;
    auto found = std::filesystem::weakly_canonical(path, error);
    return error ? path.lexically_normal() : found;
  }
  [[nodiscard]] std::filesystem::path nameOf(const std::filesystem::path& path) const override {
    const auto found = texts.find(canonical(path));
    return found == texts.end() ? path : found->second->path;
  }

private:
  std::map<std::filesystem::path, const WorkerText*> texts; ///< by their canonical names
};

/// Reads available bytes, up to the requested number.
class Input {
public:
  /// The next line without its end; nullopt if the stream ends first.
  std::optional<std::string> line() {
    while (buffer.find('\n') == std::string::npos)
      if (!more()) return std::nullopt;
    auto line = take(buffer.find('\n') + 1);
    line.pop_back();
    return line;
  }

  std::optional<std::string> bytes(std::size_t count) {
    while (buffer.size() < count)
      if (!more()) return std::nullopt;
    return take(count);
  }

private:
  bool more() {
    char chunk[65536];
    auto count = ::read(STDIN_FILENO, chunk, sizeof chunk);
    if (count < 0 && errno == EINTR) return true;
    if (count > 0) buffer.append(chunk, static_cast<std::size_t>(count));
    return count > 0;
  }

  std::string take(std::size_t count) {
    auto taken = buffer.substr(0, count);
    buffer.erase(0, count);
    return taken;
  }

  std::string buffer;
};

std::optional<JobHeader> readJob() {
  Input input;
  auto line = input.line();
  auto header = line ? decodeHeader(*line) : std::nullopt;
  if (!header) return std::nullopt;
  for (std::size_t i = 0; i < header->lengths.size(); ++i) {
    auto text = input.bytes(header->lengths[i]);
    if (!text) return std::nullopt;
    header->job.texts[i].text = std::move(*text);
  }
  return header;
}

/// Ends the process when its standard input is closed, which means that the answer is no longer
/// wanted.
void endWithInput() {
  std::thread([] {
    char byte;
    while (true) {
      auto count = ::read(STDIN_FILENO, &byte, 1);
      if (count == 0 || (count < 0 && errno != EINTR)) _exit(kAlone);
    }
  }).detach();
}

/// Limits the resources of the process. These limits also cover what the engine cannot measure.
/// They are wider than the budget, within which the engine answers.
void confine(const Budget& budget) {
  process::limitResource(RLIMIT_CORE, 0);
  process::limitResource(RLIMIT_CPU,
                         static_cast<rlim_t>(std::ceil(std::clamp(budget.seconds, 0.0, 1e8))) + 5);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // sanitizers map terabytes
  process::limitResource(RLIMIT_AS, (budget.megabytes + budget.megabytes / 2 + 512) * kMegabyte);
#endif
  constexpr int kBehindTheEditor = 10;
  [[maybe_unused]] const auto priority = nice(kBehindTheEditor);
}

void say(const OrderedJson& json) {
  auto line = json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
  std::string_view rest = line;
  while (!rest.empty()) {
    auto count = ::write(STDOUT_FILENO, rest.data(), rest.size());
    if (count < 0 && errno != EINTR) _exit(kAlone);
    if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
  }
}

void sayError(const std::string& message) { say({{"error", message}}); }

void sayProgress(const verify::Progress& now) {
  say({{"progress",
        {{"decided", now.decided},
         {"total", now.questions},
         {"classes", now.classes},
         {"markings", now.markings},
         {"waiting", now.waiting},
         {"bytes", now.bytes},
         {"seconds", now.seconds}}}});
}

/// The time limit includes the reading of the program.
verify::Options engineOptions(const Budget& budget, Clock::time_point begun) {
  verify::Options options;
  const std::chrono::duration<double> passed = Clock::now() - begun;
  options.limits.seconds = std::max(0.0, budget.seconds - passed.count());
  options.limits.bytes = budget.megabytes * kMegabyte;
  options.limits.classes = budget.classes;
  options.progress = sayProgress;
  return options;
}

/// The first name that selects no property, or null.
const std::string* unknownName(const codegen::Model& model, const std::vector<std::string>& names) {
  auto found = std::ranges::find_if(names, [&](const std::string& name) {
    return std::ranges::none_of(model.checks,
                                [&](const auto& check) { return ide::selects({name}, check); });
  });
  return found == names.end() ? nullptr : &*found;
}

/// What to verify: a program with its model, or a Fiacre model.
struct Verifiable {
  analysis::Program program;
  codegen::Model model;
};

std::expected<Verifiable, std::string> ofFiacre(const WorkerText& text) {
  auto file = ide::readFiacre(text.path, text.text);
  if (file.hasErrors())
    return std::unexpected("the model has errors: " + file.diagnostics[0].message);
  if (!file.isModel()) return std::unexpected("the text names no model");
  return Verifiable{std::move(file.program), std::move(file.model)};
}

std::expected<Verifiable, std::string> verifiableOf(const WorkerJob& job) {
  if (ide::isFiacre(job.texts.front().path)) return ofFiacre(job.texts.front());
  auto program = analysis::load(JobFiles(job.texts), job.texts.front().path);
  for (const auto& diagnostic : analysis::check(program))
    if (diagnostic.severity == syntax::Severity::Error)
      return std::unexpected("the program has errors: " + diagnostic.message);
  codegen::Options options;
  options.mainSkill = job.mainSkill;
  auto model = codegen::generate(program, options);
  if (!model) return std::unexpected(model.error().message);
  return Verifiable{std::move(program), std::move(*model)};
}

/// Sends each verdict as soon as it is decided, so that none is lost if the process is killed.
class Handover {
public:
  Handover(const Verifiable& of, const std::vector<std::string>& names) : subject(of) {
    const auto asked = ide::askedOf(of.model, names);
    told.resize(asked.checks.size());
    const verify::Result nothing{std::vector<verify::Answer>(told.size()), {}};
    const auto open = ide::reportOf(of.model, asked, nothing);
    say({{"begin", report::reportJson({of.program, of.model, open, of.model.mainSkill})}});
  }

  void decided(std::size_t index, const ide::VerdictRow& row) {
    told[index] = row.reason;
    say({{"decided",
          {{"index", index}, {"property", report::propertyJson(subject.program, row)}}}});
  }

  /// Sends the report, with null for verdicts that were sent and have not changed.
  void end(ide::VerificationReport result) {
    for (std::size_t i = 0; i < told.size(); ++i)
      if (stands(i, result)) result.rows[i].trace.reset();
    auto json =
        report::reportJson({subject.program, subject.model, result, subject.model.mainSkill});
    for (std::size_t i = 0; i < told.size(); ++i)
      if (stands(i, result)) json["properties"][i] = nullptr;
    say({{"report", std::move(json)}});
  }

private:
  [[nodiscard]] bool stands(std::size_t row, const ide::VerificationReport& result) const {
    return told[row] && *told[row] == result.rows[row].reason;
  }

  const Verifiable& subject;
  std::vector<std::optional<std::string>> told; ///< by row: the reason that was sent with it
};

/// Measures durations. The report has nothing else.
void measure(const codegen::Model& model, const WorkerJob& job, const std::string& directory,
             Clock::time_point begun) {
  const auto questions = ide::askForDurations(model);
  auto options = engineOptions(job.budget, begun);
  options.progress = {};
  const auto known = cache::cacheFor(directory, questions.model);
  options.answers = known.get();
  auto measured = ide::measureDurations(questions, options);
  if (known) (void)known->save();
  say({{"report", {{"durations", report::durationsJson(measured)}}}});
}

void work(const WorkerJob& job, const std::string& directory) {
  const auto begun = Clock::now();
  const auto subject = verifiableOf(job);
  if (!subject) return sayError(subject.error());
  const auto& model = subject->model;
  if (job.durations) return measure(model, job, directory, begun);
  if (const auto* name = unknownName(model, job.names))
    return sayError(fmt::format("no property is called `{}`", *name));
  Handover handover(*subject, job.names);
  auto options = engineOptions(job.budget, begun);
  const auto known = cache::cacheFor(directory, model);
  options.answers = known.get();
  auto result = ide::verifyModel(
      model, job.names, options,
      [&](std::size_t index, const ide::VerdictRow& row) { handover.decided(index, row); },
      ide::kTracesOfEditor);
  if (!result) return sayError("this model cannot be explored: " + result.error().message);
  if (known)
    (void)known->save(); // before the report is sent: its receiver may end this process at
                         // once
  handover.end(std::move(*result));
}

} // namespace

int runVerifyWorker(const std::string& cache) {
  const auto header = readJob();
  if (!header) return kNoJob;
  if (!process::dieWithParent(header->parentId)) return kAlone;
  endWithInput();
  confine(header->job.budget);
  try {
    work(header->job, cache);
  } catch (const std::bad_alloc&) {
    say({{"stopped", "the memory limit was reached"}});
  }
  return kDone;
}

} // namespace proskill::worker
