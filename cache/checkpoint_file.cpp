#include "cache/checkpoint_file.h"

#include "cache/model_text.h"
#include "cache/this_program.h"
#include "syntax/text/source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <array>
#include <cstring>
#include <ranges>
#include <utility>

namespace proskill::cache {

namespace {

constexpr std::string_view kFormat = "ProSkill checkpoint 1\n";
constexpr std::size_t kKeyDigits = 32;
constexpr std::uint32_t kLargestBlock = 1 << 20; // bytes
constexpr double kSharePerWrite = 10; // time between two writes, divided by the time that one takes

/// Precedes each block.
struct BlockHead {
  std::uint32_t size = 0;
  std::uint32_t unused = 0;
  std::uint64_t hash = 0; ///< of the block and all before it
};

std::uint64_t hashOf(std::string_view block, std::uint64_t before) {
  const std::uint64_t hash = XXH3_64bits_withSeed(block.data(), block.size(), before);
  return hash ^ block.size();
}

std::string questionText(const verify::Question& question) {
  return fmt::format("{} {} {} {}", question.property, question.fair, question.rests,
                     fmt::join(question.exempt, ","));
}

bool putBlock(const verify::CheckpointStore::Put& put, std::string_view block,
              std::uint64_t& hash) {
  hash = hashOf(block, hash);
  const BlockHead head{static_cast<std::uint32_t>(block.size()), 0, hash};
  std::array<char, sizeof head> bytes{};
  std::memcpy(bytes.data(), &head, sizeof head);
  return put({bytes.data(), bytes.size()}) && (block.empty() || put(block));
}

std::string otherKey(std::string_view what) {
  return fmt::format("it is the checkpoint of {}; it is left as it is: remove it to begin anew, "
                     "or name another file",
                     what);
}

} // namespace

CheckpointKey checkpointKey(const std::string& kind, const codegen::Model& model,
                            const std::vector<verify::Question>& questions,
                            const verify::Options& options) {
  const auto patterns = questions | std::views::transform([&](const auto& question) {
                          const auto& of = model.fiacre.properties.at(question.property);
                          return questionText(question) + textOf(of.pattern, model.fiacre.main);
                        });
  const auto reductions =
      options.reductions | std::views::transform([](auto it) { return static_cast<int>(it); });
  return {.build = digestOfThisProgram(),
          .model = syntax::digestOf(fmt::format(
              "{}\n{}", fmt::join(std::views::keys(model.obliged), "\n"), textOf(model.fiacre))),
          .questions = syntax::digestOf(fmt::format("{}\n{}", kind, fmt::join(patterns, "\n"))),
          .settings = syntax::digestOf(fmt::format("{} {} {}", fmt::join(reductions, ","),
                                                   options.classesBeforeSlices,
                                                   options.classesOfLedSearches))};
}

CheckpointFile::CheckpointFile(const std::filesystem::path& path, double every, CheckpointKey of,
                               Say inform)
    : file(path),
      between(every),
      key(std::move(of)),
      say(std::move(inform)),
      dueAt(Clock::now() + std::chrono::duration_cast<Clock::duration>(between)) {}

std::expected<std::unique_ptr<CheckpointFile>, std::string>
CheckpointFile::open(const std::filesystem::path& path, double every, CheckpointKey key,
                     Say inform) {
  if (key.build.empty())
    return std::unexpected("checkpoints need the file of the program `proskill`, which cannot be "
                           "read");
  std::unique_ptr<CheckpointFile> made(
      new CheckpointFile(path, every, std::move(key), std::move(inform)));
  if (auto problem = made->file.obstacle()) return std::unexpected(std::move(*problem));
  if (auto problem = made->openEarlier())
    return std::unexpected(fmt::format("`{}` cannot be used: {}", path.string(), *problem));
  return made;
}

std::string CheckpointFile::head() const {
  return fmt::format("{}build {}\nmodel {}\nquestions {}\nsettings {}\n", kFormat, key.build,
                     key.model, key.questions, key.settings);
}

/// \return why it cannot be used, or nothing, also if there is none
std::optional<std::string> CheckpointFile::openEarlier() {
  std::error_code error;
  if (!std::filesystem::exists(file.path(), error)) return std::nullopt;
  auto opened = disk::LargeFile::open(file.path());
  if (!opened) return opened.error();
  const std::string own = head();
  const std::string found = opened->read(0, own.size());
  if (!found.starts_with(kFormat)) return "it is not a checkpoint of this version of proskill";
  if (found.size() < own.size()) return "it is damaged";
  struct Line {
    std::string_view name;
    std::string_view whose;
  };
  constexpr std::array<Line, 4> kLines{{{"build ", "another build of proskill"},
                                        {"model ", "another program, or of it before a change"},
                                        {"questions ", "other properties"},
                                        {"settings ", "other reductions"}}};
  std::size_t from = kFormat.size();
  for (const auto& line : kLines) {
    const auto size = line.name.size() + kKeyDigits + 1;
    if (found.compare(from, size, own, from, size) != 0) return otherKey(line.whose);
    from += size;
  }
  earlier.emplace(std::move(*opened));
  at = own.size();
  hash = hashOf(own, 0);
  return std::nullopt;
}

bool CheckpointFile::isDue() { return Clock::now() >= dueAt; }

void CheckpointFile::replace(const std::function<void(const Put&)>& write) {
  const auto begun = Clock::now();
  const std::string own = head();
  std::uint64_t chain = hashOf(own, 0);
  const auto problem = file.replace([&](const Put& put) {
    if (!put(own)) return;
    write([&](std::string_view block) { return putBlock(put, block, chain); });
    putBlock(put, {}, chain);
  });
  const auto now = Clock::now();
  const std::chrono::duration<double> pause = (now - begun) * kSharePerWrite;
  dueAt = now + std::chrono::duration_cast<Clock::duration>(std::max(between, pause));
  if (!problem) saved = now;
  if (problem && !std::exchange(hasWarned, true) && say)
    say("warning: " + *problem + "; the verification goes on, and tries again");
}

std::expected<std::string, std::string> CheckpointFile::next() {
  BlockHead block;
  const std::string head = earlier->read(at, sizeof block);
  const auto damaged = std::unexpected(fmt::format("`{}` is damaged", file.path().string()));
  if (head.size() < sizeof block) return damaged;
  std::memcpy(&block, head.data(), sizeof block);
  if (block.size > kLargestBlock || block.unused != 0) return damaged;
  at += sizeof block;
  std::string bytes = earlier->read(at, block.size);
  at += bytes.size();
  hash = hashOf(bytes, hash);
  if (bytes.size() < block.size || hash != block.hash) return damaged;
  if (bytes.empty() && at != earlier->size()) return damaged;
  return bytes;
}

void CheckpointFile::resumed(std::uint64_t classes) {
  earlier.reset(); // it takes room on the disk even if another file has its name
  if (say)
    say(fmt::format("the search goes on from `{}`: {} classes", file.path().string(), classes));
  dueAt = Clock::now() + std::chrono::duration_cast<Clock::duration>(between);
}

void CheckpointFile::removeIfFinished() {
  if (isFinished) file.remove();
}

} // namespace proskill::cache
