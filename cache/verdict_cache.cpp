#include "cache/verdict_cache.h"

#include "cache/checked_file.h"
#include "cache/model_text.h"
#include "cache/this_program.h"
#include "syntax/text/source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <ranges>

namespace proskill::cache {

namespace {

using Json = nlohmann::json;
using verify::Evidence;
using verify::KnownAnswer;
using verify::MonitorMove;

constexpr std::string_view kExtension = ".verdicts";
constexpr std::string_view kPartsExtension = ".parts";
constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;
constexpr std::uintmax_t kBytesAfterPruning = std::uintmax_t{48} << 20;
constexpr std::chrono::seconds kBetweenSaves{1};

Json jsonOf(const std::optional<std::size_t>& number) { return number ? Json(*number) : Json(); }

std::optional<std::size_t> numberIn(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return json.get<std::size_t>();
}

Json jsonOf(const Evidence& evidence) {
  Json clocks = Json::array();
  for (const auto& it : evidence.clocks)
    clocks.push_back(Json::array({it.clock, it.lower, it.upper}));
  Json marks = Json::array();
  for (const auto& it : evidence.marks)
    marks.push_back(
        Json::array({it.after, it.until, it.atStep, it.atEnd, it.ticks, it.location, it.edge}));
  Json differences = Json::array();
  for (const auto& it : evidence.differences)
    differences.push_back(Json::array({it.a, it.b, it.limit}));
  return {{"steps", evidence.steps},
          {"clocks", std::move(clocks)},
          {"differences", std::move(differences)},
          {"marks", std::move(marks)},
          {"loop", jsonOf(evidence.loop)},
          {"rest", jsonOf(evidence.rest)}};
}

Evidence evidenceIn(const Json& json) {
  Evidence made;
  made.steps = json.at("steps").get<verify::Steps>();
  for (const auto& it : json.at("clocks"))
    made.clocks.push_back({it.at(0).get<verify::ClockId>(), it.at(1).get<verify::Bound>(),
                           it.at(2).get<verify::Bound>()});
  for (const auto& it : json.at("differences"))
    made.differences.push_back({it.at(0).get<verify::ClockId>(), it.at(1).get<verify::ClockId>(),
                                it.at(2).get<verify::Bound>()});
  for (const auto& it : json.at("marks"))
    made.marks.push_back({.after = it.at(0).get<std::size_t>(),
                          .until = it.at(1).get<std::size_t>(),
                          .atStep = it.at(2).get<bool>(),
                          .atEnd = it.at(3).get<bool>(),
                          .ticks = it.at(4).get<bool>(),
                          .location = it.at(5).get<std::uint32_t>(),
                          .edge = it.at(6).get<std::uint32_t>()});
  made.loop = numberIn(json.at("loop"));
  made.rest = numberIn(json.at("rest"));
  return made;
}

/// Null: the property holds.
Json jsonOf(const KnownAnswer& answer) {
  if (answer.holds && !answer.duration) return {};
  Json json = jsonOf(answer.evidence);
  if (const auto& time = answer.duration)
    json["time"] = {time->happens, time->bounded, time->value.value, time->value.strict};
  return json;
}

KnownAnswer answerIn(const Json& json) {
  if (json.is_null()) return {true, {}};
  const auto time = json.find("time");
  if (time == json.end()) return {false, evidenceIn(json)};
  const verify::Duration duration{
      .happens = time->at(0).get<bool>(),
      .bounded = time->at(1).get<bool>(),
      .value = {time->at(2).get<std::int64_t>(), time->at(3).get<bool>()}};
  return {true, evidenceIn(json), duration};
}

std::string keyOf(const codegen::Model& model) {
  return syntax::digestOf(fmt::format("{}\n{}\n{}", digestOfThisProgram(),
                                      fmt::join(std::views::keys(model.obliged), "\n"),
                                      textOf(model.fiacre)));
}

/// The file about parts is that of all programs with this name.
std::filesystem::path partsFile(const std::filesystem::path& directory,
                                const codegen::Model& model) {
  if (digestOfThisProgram().empty()) return {};
  return directory /
         (syntax::digestOf(fmt::format("{}\n{}", digestOfThisProgram(), model.fiacre.main)) +
          std::string(kPartsExtension));
}

/// The same steps in a model whose transitions have the numbers; nothing if one of them is gone.
std::optional<Evidence> translated(Evidence evidence, const std::vector<std::string>& names,
                                   const std::map<std::string, verify::TransitionId>& numbers) {
  if (!evidence.clocks.empty() || !evidence.differences.empty()) return std::nullopt; // no names
  for (auto& step : evidence.steps) {
    const auto found = step < names.size() ? numbers.find(names[step]) : numbers.end();
    if (found == numbers.end()) return std::nullopt;
    step = found->second;
  }
  return evidence;
}

/// Removes the least recently used files. Other processes may do so at the same time.
void prune(const std::filesystem::path& directory) {
  struct File {
    std::filesystem::path path;
    std::filesystem::file_time_type used;
    std::uintmax_t bytes = 0;
  };
  std::vector<File> files;
  std::uintmax_t bytes = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(directory, error)) {
    const auto extension = entry.path().extension();
    if (extension != kExtension && extension != kPartsExtension) continue;
    std::error_code gone;
    File file{entry.path(), entry.last_write_time(gone), entry.file_size(gone)};
    if (gone) continue;
    bytes += file.bytes;
    files.push_back(std::move(file));
  }
  if (bytes <= kMostBytes) return;
  std::ranges::sort(files, {}, &File::used);
  for (const auto& file : files) {
    if (bytes <= kBytesAfterPruning) return;
    std::filesystem::remove(file.path, error);
    bytes -= file.bytes;
  }
}

} // namespace

VerdictCache::VerdictCache(std::filesystem::path in, const codegen::Model& model)
    : directory(std::move(in)),
      parts(partsFile(directory, model)),
      savedAt(std::chrono::steady_clock::now()) {
  if (digestOfThisProgram().empty()) return;
  file = directory / (cache::keyOf(model) + std::string(kExtension));
  for (const auto& property : model.fiacre.properties)
    properties.push_back(syntax::digestOf(textOf(property.pattern, model.fiacre.main)));
  verdicts = read(file);
  std::error_code error; // mark the file as used, so that it is kept
  if (!verdicts.answers.empty())
    std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now(), error);
}

VerdictCache::~VerdictCache() { (void)save(); }

std::string VerdictCache::keyOf(const verify::Question& question) const {
  return properties.at(question.property) +
         (question.fair    ? "f"
          : question.rests ? "r"
                           : "") +
         (question.exempt.empty()
              ? ""
              : "-" + syntax::digestOf(fmt::format("{}", fmt::join(question.exempt, "\n"))));
}

std::optional<KnownAnswer> VerdictCache::find(const verify::Question& question) {
  if (file.empty()) return std::nullopt;
  const auto found = verdicts.answers.find(keyOf(question));
  return found == verdicts.answers.end() ? std::nullopt : std::optional(found->second);
}

void VerdictCache::keep(const verify::Question& question, const KnownAnswer& answer) {
  if (file.empty()) return;
  auto& kept = verdicts.answers[keyOf(question)] = answer;
  kept.evidence.monitor = nullptr;
  saveSometimes();
}

void VerdictCache::saveSometimes() {
  isSaved = false;
  if (std::chrono::steady_clock::now() - savedAt >= kBetweenSaves) (void)save();
}

void VerdictCache::begin(const std::vector<std::string>& stepNames) {
  verdicts.steps = stepNames;
  const auto& last = parts.lastModel();
  if (file.empty() || last.empty() || last == file.filename()) return;
  std::map<std::string, verify::TransitionId> numbers;
  for (std::size_t i = 0; i < stepNames.size(); ++i)
    numbers.emplace(stepNames[i], static_cast<verify::TransitionId>(i));
  const Verdicts before = read(directory / std::filesystem::path(last).filename());
  for (const auto& [key, answer] : before.answers)
    if (!answer.holds)
      if (auto evidence = translated(answer.evidence, before.steps, numbers))
        violations.emplace(key, std::move(*evidence));
}

std::optional<Evidence> VerdictCache::earlier(const verify::Question& question) {
  if (file.empty()) return std::nullopt;
  const auto found = violations.find(keyOf(question));
  return found == violations.end() ? std::nullopt : std::optional(found->second);
}

bool VerdictCache::isNeverIn(const std::string& text) {
  return parts.contains(syntax::digestOf(text));
}

void VerdictCache::keepNeverIn(const std::string& text) {
  parts.insert(syntax::digestOf(text));
  saveSometimes();
}

VerdictCache::Verdicts VerdictCache::read(const std::filesystem::path& file) {
  const auto json = readChecked(file);
  if (!json) return {};
  try {
    Verdicts found;
    found.steps = json->at("steps").get<std::vector<std::string>>();
    for (const auto& [key, kept] : json->at("answers").items())
      found.answers.emplace(key, answerIn(kept));
    return found;
  } catch (const Json::exception&) {
    return {};
  }
}

/// A version that was given up early is not the one that the next is compared with.
std::optional<std::string> VerdictCache::save() {
  if (isSaved || file.empty()) return std::nullopt;
  savedAt = std::chrono::steady_clock::now();
  isSaved = true;
  Verdicts others = read(file);
  verdicts.answers.merge(others.answers);
  if (verdicts.steps.empty()) verdicts.steps = std::move(others.steps);
  Json all = Json::object();
  for (const auto& [key, answer] : verdicts.answers) all[key] = jsonOf(answer);
  if (auto problem = writeChecked(file, {{"answers", std::move(all)}, {"steps", verdicts.steps}}))
    return problem;
  if (verdicts.answers.size() * 2 >= properties.size()) parts.setLastModel(file.filename());
  if (auto problem = parts.save()) return problem;
  prune(directory);
  return std::nullopt;
}

std::unique_ptr<VerdictCache> cacheFor(const std::filesystem::path& directory,
                                       const codegen::Model& model) {
  if (directory.empty()) return nullptr;
  return std::make_unique<VerdictCache>(directory, model);
}

std::filesystem::path usersDirectory() {
  const auto set = [](const char* name) -> std::filesystem::path {
    const char* value = std::getenv(name);
    return value ? value : "";
  };
  if (const auto caches = set("XDG_CACHE_HOME"); caches.is_absolute())
    return caches / "proskill/verdicts";
  const auto home = set("HOME");
  return home.is_absolute() ? home / ".cache/proskill/verdicts" : "";
}

} // namespace proskill::cache
