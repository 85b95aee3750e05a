#pragma once

#include "report/ordered_json.h"
#include "verify/verify.h"
#include "view/panel_json.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace proskill::view {

/// The data of `proskill view`. Any thread may call it.
class PanelData {
public:
  using Answer = std::expected<OrderedJson, std::string>;

  virtual ~PanelData() = default;

  /// As `proskill verify --format json` has it, with the number of steps in place of each trace,
  /// and with what else the panel wants of a program.
  [[nodiscard]] virtual OrderedJson program() = 0;
  [[nodiscard]] virtual Answer trace(const std::string& name) = 0;
  [[nodiscard]] virtual Answer picture(const PictureParams& params) = 0;
  [[nodiscard]] virtual Answer source(const std::string& uri) = 0;
  /// A run with these steps, as report/simulation_json.h has it.
  [[nodiscard]] virtual Answer simulate(const OrderedJson& params) = 0;
  [[nodiscard]] virtual bool canSimulate() const = 0;
  /// Restarts.
  virtual void verify() = 0;
  [[nodiscard]] virtual bool canVerify() const = 0;
};

/// Notifications to the open pages. Waiting pages do not need a thread each.
class EventFeed {
public:
  using Tell = std::function<void(OrderedJson)>;

  EventFeed() : teller([this] { tellAll(); }) {}
  ~EventFeed() { close(); }
  EventFeed(const EventFeed&) = delete;
  EventFeed& operator=(const EventFeed&) = delete;

  void announce(std::string method, OrderedJson params);
  /// Tells `{next, news}`: what came after the first `after` news, once there is some; nothing
  /// where there is none for long, or where too many wait.
  void after(std::size_t after, Tell tell);
  /// Ends all waits.
  void close();

private:
  using Time = std::chrono::steady_clock::time_point;
  struct Waiting {
    std::size_t after;
    Time until;
    Tell tell;
  };

  void tellAll();
  std::vector<Waiting> takeDue(Time now);
  [[nodiscard]] OrderedJson newsAfter(std::size_t after) const;

  std::mutex mutex;
  std::condition_variable changed;
  std::deque<OrderedJson> kept;
  std::size_t count = 0;       ///< of all, those that are no longer kept too
  std::deque<Waiting> waiting; ///< in the order of their times
  bool closed = false;
  std::jthread teller; ///< the last member: it uses the others
};

struct ViewOptions {
  std::string file;
  std::string mainSkill;
  verify::Limits limits;
};

/// A program, verified in the background, and again whenever one of its files changes.
[[nodiscard]] std::unique_ptr<PanelData> liveProgram(ViewOptions options, EventFeed& news);

/// A report or a trace that was saved in a file.
[[nodiscard]] std::expected<std::unique_ptr<PanelData>, std::string>
savedReport(const std::string& file, const std::string& text);

} // namespace proskill::view
