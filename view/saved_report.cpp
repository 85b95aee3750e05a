#include "disk/disk.h"
#include "report/ordered_json.h"
#include "report/run/read_recording.h"
#include "report/sources.h"
#include "view/panel_data.h"

#include <algorithm>
#include <mutex>
#include <set>
#include <utility>

namespace proskill::view {

namespace {

/// Whether a recorded run has no faults.
bool isGoodRun(const OrderedJson& recording) {
  static const std::set<std::string> kBad{"undershoot", "overshoot", "alarm", "fault", "violated"};
  const auto steps = recording.find("steps");
  return steps == recording.end() || std::ranges::none_of(*steps, [](const OrderedJson& step) {
           const auto remark = step.is_object() ? step.find("remark") : step.end();
           return remark != step.end() && remark->is_string() &&
                  kBad.contains(remark->get<std::string>());
         });
}

/// A member of an object that is a text.
std::string textOf(const OrderedJson& object, const char* name, const std::string& otherwise) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

/// Makes a report of one property from a trace. That of a part of a recording is about the run.
OrderedJson asReport(const std::string& file, OrderedJson trace) {
  const auto name = textOf(trace, "name", "trace");
  const auto verdict = textOf(trace, "verdict", "");
  const auto part = trace.value("part", OrderedJson());
  OrderedJson property{{"name", name},
                       {"kind", "trace"},
                       {"subject", ""},
                       {"description", textOf(part, "run", textOf(trace, "description", name))},
                       {"verdict", verdict},
                       {"good", verdict == "reachable" || verdict == "holds" ||
                                    (verdict == "recorded" && isGoodRun(trace))},
                       {"severity", "error"},
                       {"location", nullptr},
                       {"trace", std::move(trace)}};
  return {{"version", 1},
          {"program", file},
          {"main", nullptr},
          {"properties", OrderedJson::array({std::move(property)})},
          {"exploration", nullptr}};
}

class SavedReport : public PanelData {
public:
  SavedReport(std::string ofFile, OrderedJson saved, ReadPart read)
      : file(std::move(ofFile)), report(std::move(saved)), readPart(std::move(read)) {
    const auto label = std::filesystem::path(file).filename().generic_string();
    for (auto& property : report["properties"])
      if (auto trace = takeTrace(property)) traces[property.value("name", "")] = std::move(*trace);
    OrderedJson list = OrderedJson::array();
    for (const auto& path : files)
      list.push_back(
          {{"uri", path}, {"label", std::filesystem::path(path).filename().generic_string()}});
    report.update({{"label", label},
                   {"state", "done"},
                   {"stale", false},
                   {"message", ""},
                   {"progress", nullptr},
                   {"pictures", OrderedJson::array()},
                   {"files", std::move(list)}});
  }

  OrderedJson program() override { return report; }

  Answer trace(const std::string& name) override {
    const auto found = traces.find(name);
    if (found == traces.end()) return std::unexpected("this property has no trace");
    return compared(found->second);
  }

  Answer part(std::optional<double> from) override {
    if (!readPart) return PanelData::part(from);
    const auto text = readPart(from);
    if (!text) return std::unexpected(text.error());
    auto trace = parsedJson(*text);
    if (!trace.is_object()) return std::unexpected("this part is damaged");
    auto property = asReport(file, std::move(trace))["properties"][0];
    auto taken = takeTrace(property);
    if (!taken) return std::unexpected("this part has no steps");
    return compared(std::move(*taken));
  }

  Answer picture(const PictureParams&) override {
    return std::unexpected("pictures need the program: open it instead");
  }

  /// Serves only files that occur in the traces.
  Answer source(const std::string& uri) override {
    if (!isOfTrace(uri)) return std::unexpected("the traces do not refer to this file");
    auto text = disk::DiskFileSystem().read(uri);
    if (!text) return std::unexpected(uri + " cannot be read: " + text.error());
    return OrderedJson{{"uri", uri}, {"text", std::move(*text)}};
  }

  Answer simulate(const OrderedJson&) override {
    return std::unexpected("simulations need the program: open it instead");
  }
  [[nodiscard]] bool canSimulate() const override { return false; }

  void verify() override {}
  [[nodiscard]] bool canVerify() const override { return false; }

private:
  /// The trace, which says if its texts have been edited since.
  static OrderedJson compared(OrderedJson trace) {
    const auto textOf = [](const std::string& path) { return disk::DiskFileSystem().read(path); };
    if (!report::editedSources(trace, textOf).empty()) trace["stale"] = true;
    return trace;
  }

  /// Removes the trace from a property, if it has one.
  std::optional<OrderedJson> takeTrace(OrderedJson& property) {
    const auto trace = std::exchange(property["trace"], nullptr);
    property["steps"] = nullptr; // the report may be without this trace
    if (!trace.is_object() || !trace.at("steps").is_array()) return std::nullopt;
    property["steps"] = trace["steps"].size();
    noteFiles(trace["steps"]);
    const auto name = property.value("name", "");
    OrderedJson about{{"name", name},
                      {"description", property.value("description", name)},
                      {"verdict", property["verdict"]}};
    about.update(trace);
    return std::optional<OrderedJson>(std::in_place, std::move(about));
  }

  bool isOfTrace(const std::string& uri) {
    const std::lock_guard lock(mutex);
    return files.contains(uri);
  }

  void noteFiles(const OrderedJson& steps) {
    const std::lock_guard lock(mutex);
    for (const auto& step : steps) {
      const auto location = step.find("location");
      if (location == step.end() || !location->is_object()) continue;
      // files saved by the panel have places in the form of editors
      for (const auto* member : {"file", "uri"})
        if (const auto path = location->find(member); path != location->end() && path->is_string())
          files.insert(path->get<std::string>());
    }
  }

  std::string file;
  OrderedJson report;
  std::map<std::string, OrderedJson> traces;
  ReadPart readPart; ///< may be empty
  std::mutex mutex;
  std::set<std::string> files; ///< under `mutex`
};

} // namespace

std::expected<std::unique_ptr<PanelData>, std::string>
savedReport(const std::string& file, const std::string& text, ReadPart readPart) {
  auto json = parsedJson(text);
  if (json.is_discarded()) json = parsedJson(report::completed(text));
  if (json.is_discarded()) return std::unexpected("`" + file + "` is not valid JSON");
  const bool isTrace = json.is_object() && json.contains("steps") && json["steps"].is_array();
  const bool isReport =
      json.is_object() && json.contains("properties") && json["properties"].is_array();
  if (!isTrace && !isReport)
    return std::unexpected("`" + file + "` is neither a report nor a trace of `proskill verify`");
  try {
    return std::make_unique<SavedReport>(
        file, isTrace ? asReport(file, std::move(json)) : std::move(json), std::move(readPart));
  } catch (const OrderedJson::exception&) {
    return std::unexpected("`" + file + "` is not a report of `proskill verify`");
  }
}

} // namespace proskill::view
