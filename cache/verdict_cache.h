#pragma once

#include "codegen/model.h"
#include "verify/answer_store.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

/// Verdicts that outlive the process that found them.
namespace proskill::cache {

/// What was decided about one model, in a file of a directory that any number of processes share.
/// The file's name is a digest of all that a verdict depends on: the model's text without its
/// properties, the processes that fair runs oblige, the program's build. So comments, layout and
/// messages of a program cost nothing, and no verdict is ever taken for another model's. A file
/// that is damaged counts as none, and what would take more than 16 MB is not written.
class VerdictCache : public verify::AnswerStore {
public:
  /// \param directory made where it is missing \param model is not looked at later
  VerdictCache(std::filesystem::path directory, const codegen::Model& model);
  /// Saves what is not saved.
  ~VerdictCache() override;

  [[nodiscard]] std::optional<verify::KnownAnswer> find(const verify::Question& question) override;
  /// Saves now and then, so that a process that is killed leaves what it knew a second before.
  void keep(const verify::Question& question, const verify::KnownAnswer& answer) override;

  /// Writes what is not written, with what other processes have written of the model since, and
  /// removes the files that were not used for the longest time where all of them take too much
  /// room. \return what went wrong, in words, or nothing
  [[nodiscard]] std::optional<std::string> save();

private:
  using Answers = std::map<std::string, verify::KnownAnswer>; ///< by the question's digest

  [[nodiscard]] Answers read() const;
  [[nodiscard]] std::string keyOf(const verify::Question& question) const;

  std::filesystem::path directory;
  std::filesystem::path file;          ///< empty: nothing is kept
  std::vector<std::string> properties; ///< digests
  Answers answers;
  bool isSaved = true;
  std::chrono::steady_clock::time_point savedAt;
};

/// The cache for a model; null where the directory is empty.
[[nodiscard]] std::unique_ptr<VerdictCache> cacheFor(const std::filesystem::path& directory,
                                                     const codegen::Model& model);

/// Where editors keep verdicts: `$XDG_CACHE_HOME/proskill/verdicts`, in `~/.cache` without that.
/// Empty where there is no home.
[[nodiscard]] std::filesystem::path usersDirectory();

} // namespace proskill::cache
