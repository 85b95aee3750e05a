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
#include <optional>
#include <thread>
#include <vector>

namespace proskill::view {

/// The data of `proskill view`. Thread-safe.
class PanelData {
public:
  using Answer = std::expected<OrderedJson, std::string>;

  virtual ~PanelData() = default;

  /// The report of `proskill verify --format json`, with the number of steps instead of each trace,
  /// and with further data for the panel.
  [[nodiscard]] virtual OrderedJson program() = 0;
  [[nodiscard]] virtual Answer trace(const std::string& name) = 0;
  /// Another part of a long recording. \param from in seconds since the start of the run; nullopt:
  /// its last part
  [[nodiscard]] virtual Answer part(std::optional<double> /*from*/) {
    return std::unexpected("this is not a recording of which a part is shown");
  }
  [[nodiscard]] virtual Answer picture(const PictureParams& params) = 0;
  [[nodiscard]] virtual Answer source(const std::string& uri) = 0;
  /// A run with these steps, in the format of report/simulation_json.h.
  [[nodiscard]] virtual Answer simulate(const OrderedJson& params) = 0;
  [[nodiscard]] virtual bool canSimulate() const = 0;
  /// Starts verification again.
  virtual void verify() = 0;
  [[nodiscard]] virtual bool canVerify() const = 0;

  // A run while it happens (docs/runtime.md); other data have none.
  /// How it may be controlled, and its status; null: it is not a run.
  [[nodiscard]] virtual OrderedJson run() { return nullptr; }
  [[nodiscard]] virtual Answer steps(const OrderedJson&) { return notARun(); }
  [[nodiscard]] virtual Answer control(const OrderedJson&) { return notARun(); }

private:
  static Answer notARun() { return std::unexpected("this is not a run"); }
};

/// Notifications to open pages. Waiting pages do not occupy a thread each.
class EventFeed {
public:
  using Tell = std::function<void(OrderedJson)>;

  EventFeed() : teller([this] { tellAll(); }) {}
  ~EventFeed() { close(); }
  EventFeed(const EventFeed&) = delete;
  EventFeed& operator=(const EventFeed&) = delete;

  void announce(std::string method, OrderedJson params);
  /// Calls `tell` with `{next, news}`: the news after the first `after`, once there are some; with
  /// nothing if none come for a long time, or if too many pages wait.
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
  std::size_t count = 0;       ///< of all news, including those no longer kept
  std::deque<Waiting> waiting; ///< ordered by time
  bool closed = false;
  std::jthread teller; ///< the last member, since it uses the others
};

struct ViewOptions {
  std::string file;
  std::string mainSkill;
  verify::Limits limits;
};

/// A program that is verified in the background, and again whenever one of its files changes.
[[nodiscard]] std::unique_ptr<PanelData> liveProgram(ViewOptions options, EventFeed& news);

/// Reads a part of a recording as a trace in JSON. \param from in seconds since the start of the
/// run; nullopt: its last part
using ReadPart = std::function<std::expected<std::string, std::string>(std::optional<double> from)>;

/// A report or a trace saved in a file. \param readPart for a recording of which the text is a part
[[nodiscard]] std::expected<std::unique_ptr<PanelData>, std::string>
savedReport(const std::string& file, const std::string& text, ReadPart readPart = {});

} // namespace proskill::view
