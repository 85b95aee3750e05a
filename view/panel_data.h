#pragma once

#include "verify/verify.h"
#include "view/panel_json.h"

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>

namespace proskill::cli {

/// What `proskill view` shows. Any thread may ask.
class PanelData {
public:
  using Json = nlohmann::ordered_json;
  using Answer = std::expected<Json, std::string>;

  virtual ~PanelData() = default;

  /// As `proskill verify --format json` has it, with the number of steps in place of each trace,
  /// and with what else the panel wants of a program.
  [[nodiscard]] virtual Json program() = 0;
  [[nodiscard]] virtual Answer trace(const std::string& name) = 0;
  [[nodiscard]] virtual Answer picture(const PictureParams& params) = 0;
  [[nodiscard]] virtual Answer source(const std::string& uri) = 0;
  /// Begins anew.
  virtual void verify() = 0;
  [[nodiscard]] virtual bool canVerify() const = 0;
};

/// What there is to tell the pages that are open.
class EventFeed {
public:
  using Json = nlohmann::ordered_json;

  void announce(std::string method, Json params);
  /// `{next, news}`: what came after the first `after` news. Waits for some, but not for ever.
  [[nodiscard]] Json after(std::size_t after);
  /// Nobody waits any longer.
  void close();

private:
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Json> kept;
  std::size_t count = 0; ///< of all, those that are no longer kept too
  bool closed = false;
};

struct ViewOptions {
  std::string file;
  std::string mainSkill;
  verify::Limits limits;
};

/// A program, verified in the background, and again whenever one of its files changes.
[[nodiscard]] std::unique_ptr<PanelData> liveProgram(ViewOptions options, EventFeed& news);

/// A report or a trace that was saved in a file. What is wrong with its text is the error.
[[nodiscard]] std::expected<std::unique_ptr<PanelData>, std::string>
savedReport(const std::string& file, const std::string& text);

} // namespace proskill::cli
