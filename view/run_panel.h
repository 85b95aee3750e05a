#pragma once

#include "runtime/executor/executor.h"
#include "view/observed_run.h"
#include "view/run_feed.h"

namespace proskill::view {

/// The data of a page that shows a run while it happens, and afterwards.
class RunPanel final : public PanelData {
public:
  RunPanel(ObservedRun of, EventFeed& news);

  /// The run's: see RunFeed.
  bool push(std::string_view line) { return feed.push(line); }
  /// Whether there are events or interrupts that the run may take.
  [[nodiscard]] bool takesSignals() const;
  /// The run has ended.
  void finish(const runtime::RunResult& result);

  OrderedJson program() override;
  Answer trace(const std::string& name) override;
  Answer picture(const PictureParams& params) override;
  Answer source(const std::string& uri) override;
  Answer simulate(const OrderedJson& params) override;
  [[nodiscard]] bool canSimulate() const override { return false; }
  void verify() override {}
  [[nodiscard]] bool canVerify() const override { return false; }
  OrderedJson run() override;
  Answer steps(const OrderedJson& params) override;
  Answer control(const OrderedJson& params) override;

private:
  [[nodiscard]] OrderedJson signals() const;
  [[nodiscard]] std::string whyNotSent(std::size_t signal) const;
  [[nodiscard]] OrderedJson status() const;
  [[nodiscard]] std::string stateOf() const;
  /// \return why it is refused; empty: done
  std::string obey(const std::string& action, const std::string& signal);
  std::string pauseOr(const std::string& action);
  std::string send(const std::string& signal);
  std::string end();
  std::string close();
  [[nodiscard]] bool isOver() const;

  const ObservedRun observed;
  std::mutex controls;      ///< one at a time
  mutable std::mutex mutex; ///< guards the result
  OrderedJson result;       ///< null: it still runs
  RunFeed feed;             ///< the last member, since its thread uses the others
};

} // namespace proskill::view
