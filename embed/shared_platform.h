#pragma once

#include "embed/function_platform.h"
#include "runtime/platform/descriptor.h"

#include <memory>

namespace proskill::embed {

/// Divides the actions between the functions of another program and a platform. Events come from
/// both.
class SharedPlatform final : public runtime::Platform {
public:
  /// \pre the functions outlive this
  explicit SharedPlatform(FunctionPlatform& functions);

  /// Lets a platform perform what no function performs.
  void add(std::unique_ptr<runtime::Platform> platform);
  /// Also reports what this descriptor announces, until the end of the run.
  void addDescriptor(int other) { watch.add(other); }
  /// Is readable when there is a report, before and after a platform is added.
  [[nodiscard]] int descriptor() const { return watch.get(); }

  void start(const runtime::Start& start, runtime::Nanoseconds date) override;
  bool stop(std::uint32_t action, runtime::RunNumber run, runtime::Nanoseconds date) override;
  void abandon(std::uint32_t action, runtime::RunNumber run, runtime::Nanoseconds date) override;
  [[nodiscard]] std::optional<runtime::Nanoseconds> next() const override;
  bool poll(runtime::Nanoseconds date, runtime::Report& report) override;
  [[nodiscard]] bool mayReport() const override;
  void close() override;
  [[nodiscard]] bool isClosed() const override;
  void addDescriptors(std::vector<int>& all) const override { all.push_back(descriptor()); }

private:
  [[nodiscard]] runtime::Platform& performer(std::uint32_t action);

  FunctionPlatform& own;
  std::unique_ptr<runtime::Platform> other; ///< may be null
  runtime::Watch watch;
};

} // namespace proskill::embed
