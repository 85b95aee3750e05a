#pragma once

#include "codegen/model.h"
#include "disk/durable_file.h"
#include "disk/large_file.h"
#include "verify/checkpoint_store.h"
#include "verify/verify.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace proskill::cache {

/// Digests of everything that the state of a verification depends on.
struct CheckpointKey {
  std::string build;     ///< of proskill
  std::string model;     ///< without comments and properties
  std::string questions; ///< and what is done: a verification, or counting classes
  std::string settings;  ///< reductions and other options that results depend on
};

/// \param kind of the search that is saved: `verify`, or `classes`
[[nodiscard]] CheckpointKey checkpointKey(const std::string& kind, const codegen::Model& model,
                                          const std::vector<verify::Question>& questions,
                                          const verify::Options& options);

/// The state of a verification in a file. It begins with its format and its key as text. Blocks of
/// bytes follow, each with a hash that continues that of the block before, and an empty block at
/// the end: so a damaged or shortened file is noticed before anything of it is used.
class CheckpointFile : public verify::CheckpointStore {
public:
  using Say = std::function<void(const std::string&)>;

  /// Opens an existing file, or makes sure that one can be written. The error is a message.
  /// \param every seconds between two writes; it takes longer if they would take more than a tenth
  /// of the time
  /// \param inform receives where the search goes on, and the first problem with writing
  [[nodiscard]] static std::expected<std::unique_ptr<CheckpointFile>, std::string>
  open(const std::filesystem::path& path, double every, CheckpointKey key, Say inform);

  [[nodiscard]] bool isDue() override;
  void replace(const std::function<void(const Put&)>& write) override;
  [[nodiscard]] bool hasState() const override { return earlier.has_value(); }
  [[nodiscard]] std::expected<std::string, std::string> next() override;
  void resumed(std::uint64_t classes) override;
  void finished() override { isFinished = true; }

  /// When this process last wrote it, if it did.
  [[nodiscard]] std::optional<std::chrono::steady_clock::time_point> savedAt() const {
    return saved;
  }
  [[nodiscard]] bool isNeeded() const { return !isFinished; }
  [[nodiscard]] const std::filesystem::path& path() const { return file.path(); }
  /// Call this when the results have been delivered: nobody needs the file any more if the
  /// verification has finished.
  void removeIfFinished();

private:
  using Clock = std::chrono::steady_clock;

  CheckpointFile(const std::filesystem::path& path, double every, CheckpointKey of, Say inform);
  [[nodiscard]] std::optional<std::string> openEarlier();
  [[nodiscard]] std::string head() const;

  disk::DurableFile file;
  std::chrono::duration<double> between;
  CheckpointKey key;
  Say say;
  bool hasWarned = false;
  bool isFinished = false;
  Clock::time_point dueAt;
  std::optional<Clock::time_point> saved;

  std::optional<disk::LargeFile> earlier;
  std::uint64_t at = 0;   ///< where the next block of `earlier` begins
  std::uint64_t hash = 0; ///< of all before it
};

} // namespace proskill::cache
