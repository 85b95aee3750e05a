#pragma once

#include "cache/kept_parts.h"
#include "codegen/model.h"
#include "verify/answer_store.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

/// Verdicts that are kept across processes.
namespace proskill::cache {

/// The verdicts on one model, in a file of a directory that many processes may share. The file's
/// name is a digest of everything that a verdict depends on: the model's text without its
/// properties, the processes that fair runs oblige, and the program's build. So comments, layout
/// and messages of a program do not matter, and a verdict is never used for another model. What
/// holds in parts of the model, and the runs that violate its properties, also serve other versions
/// of the program. A damaged file is ignored, and a file larger than 16 MB is not written.
class VerdictCache : public verify::AnswerStore {
public:
  /// \param directory created if missing
  /// \param model used only by the constructor
  VerdictCache(std::filesystem::path directory, const codegen::Model& model);
  /// Saves what is not saved yet.
  ~VerdictCache() override;

  [[nodiscard]] std::optional<verify::KnownAnswer> find(const verify::Question& question) override;
  /// Saves from time to time, so that a killed process loses only about a second's verdicts.
  void keep(const verify::Question& question, const verify::KnownAnswer& answer) override;
  void begin(const std::vector<std::string>& stepNames) override;
  [[nodiscard]] std::optional<verify::Evidence> earlier(const verify::Question& question) override;
  [[nodiscard]] bool isNeverIn(const std::string& text) override;
  void keepNeverIn(const std::string& text) override;

  /// Writes new verdicts, merged with what other processes have written about the model. If all
  /// files together take too much room, removes the least recently used ones.
  /// \return an error message, or nothing
  [[nodiscard]] std::optional<std::string> save();

private:
  /// The content of a file.
  struct Verdicts {
    std::map<std::string, verify::KnownAnswer> answers; ///< by digest of the question
    std::vector<std::string> steps;                     ///< the names of the model's transitions
  };

  [[nodiscard]] static Verdicts read(const std::filesystem::path& file);
  void saveSometimes();
  [[nodiscard]] std::string keyOf(const verify::Question& question) const;

  std::filesystem::path directory;
  std::filesystem::path file;          ///< empty: nothing is saved
  std::vector<std::string> properties; ///< digests
  Verdicts verdicts;
  /// Of the last version: the violations, with the transitions of this version.
  std::map<std::string, verify::Evidence> violations;
  KeptParts parts;
  bool isSaved = true;
  std::chrono::steady_clock::time_point savedAt;
};

/// The cache for a model; null if `directory` is empty.
[[nodiscard]] std::unique_ptr<VerdictCache> cacheFor(const std::filesystem::path& directory,
                                                     const codegen::Model& model);

/// The directory in which editors keep verdicts: `$XDG_CACHE_HOME/proskill/verdicts`, by default in
/// `~/.cache`. Empty if there is no home directory.
[[nodiscard]] std::filesystem::path usersDirectory();

} // namespace proskill::cache
