#include "cache/verdict_cache.h"

#include "cache/digest.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "fiacre/print/print.h"

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
constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;
constexpr std::uintmax_t kBytesAfterPruning = std::uintmax_t{48} << 20;
/// A larger file would displace all others.
constexpr std::size_t kLargestFile = std::size_t{16} << 20;
constexpr std::size_t kDigits = 32;
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
  return {{"steps", evidence.steps},
          {"clocks", std::move(clocks)},
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

/// The text without comments, which contain the provenance.
std::string withoutComments(std::string_view text) {
  std::string kept;
  while (!text.empty()) {
    const auto line = text.substr(0, text.find('\n'));
    kept.append(line.substr(0, line.find("//"))).append("\n");
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return kept;
}

/// The text of the program without its properties, but with those that others refer to by name.
std::string textOf(fiacre::Program program) {
  std::erase_if(program.properties, [](const auto& property) { return property.asserted; });
  return withoutComments(fiacre::print(program));
}

/// Includes the number of the kind, since some kinds have no text in Fiacre.
std::string textOf(const fiacre::Pattern& pattern, const std::string& main) {
  return fmt::format("{} {}", static_cast<int>(pattern.kind), fiacre::printPattern(pattern, main));
}

std::string keyOf(const codegen::Model& model) {
  return digestOf(fmt::format("{}\n{}\n{}", digestOfThisProgram(),
                              fmt::join(std::views::keys(model.obliged), "\n"),
                              textOf(model.fiacre)));
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
    if (entry.path().extension() != kExtension) continue;
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
    : directory(std::move(in)), savedAt(std::chrono::steady_clock::now()) {
  if (digestOfThisProgram().empty()) return;
  file = directory / (cache::keyOf(model) + std::string(kExtension));
  for (const auto& property : model.fiacre.properties)
    properties.push_back(digestOf(textOf(property.pattern, model.fiacre.main)));
  answers = read();
  std::error_code error; // mark the file as used, so that it is kept
  if (!answers.empty())
    std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now(), error);
}

VerdictCache::~VerdictCache() { (void)save(); }

std::string VerdictCache::keyOf(const verify::Question& question) const {
  return properties.at(question.property) + (question.fair ? "f" : "");
}

std::optional<KnownAnswer> VerdictCache::find(const verify::Question& question) {
  if (file.empty()) return std::nullopt;
  const auto found = answers.find(keyOf(question));
  return found == answers.end() ? std::nullopt : std::optional(found->second);
}

void VerdictCache::keep(const verify::Question& question, const KnownAnswer& answer) {
  if (file.empty()) return;
  auto& kept = answers[keyOf(question)] = answer;
  kept.evidence.monitor = nullptr;
  isSaved = false;
  if (std::chrono::steady_clock::now() - savedAt >= kBetweenSaves) (void)save();
}

/// The file begins with the digest of its rest.
VerdictCache::Answers VerdictCache::read() const {
  const auto bytes = disk::DiskFileSystem().read(file);
  if (!bytes || bytes->size() < kDigits) return {};
  const auto body = std::string_view(*bytes).substr(kDigits);
  if (digestOf(body) != std::string_view(*bytes).substr(0, kDigits)) return {};
  try {
    Answers found;
    const Json all = Json::from_cbor(body);
    for (const auto& [key, json] : all.items())
      found.emplace(key,
                    json.is_null() ? KnownAnswer{true, {}} : KnownAnswer{false, evidenceIn(json)});
    return found;
  } catch (const Json::exception&) {
    return {};
  }
}

std::optional<std::string> VerdictCache::save() {
  if (isSaved || file.empty()) return std::nullopt;
  savedAt = std::chrono::steady_clock::now();
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    return fmt::format("the directory `{}` cannot be made: {}", directory.string(),
                       error.message());
  answers.merge(read());
  Json all = Json::object();
  for (const auto& [key, answer] : answers)
    all[key] = answer.holds ? Json() : jsonOf(answer.evidence);
  std::string body;
  Json::to_cbor(all, body);
  isSaved = true;
  if (body.size() > kLargestFile) return std::nullopt;
  if (auto problem = disk::writeFile(file, digestOf(body) + body)) return problem;
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
