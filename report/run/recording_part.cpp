#include "report/run/recording_part.h"

#include "report/ordered_json.h"
#include "report/run/read_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace proskill::report {

namespace {

/// Which stretches are read: the first and the one after the last.
std::pair<std::size_t, std::size_t> chosen(const std::vector<mcap::Stretch>& all,
                                           const PartOfRun& part) {
  std::uint64_t size = 0;
  if (!part.from) {
    auto first = all.size();
    while (first > 0 && (size == 0 || size + all[first - 1].size <= part.bytes))
      size += all[--first].size;
    return {first, all.size()};
  }
  const auto from =
      all.front().first + static_cast<std::uint64_t>(std::clamp(*part.from, 0.0, 1e9) * 1e9);
  const auto found = std::ranges::find_if(all, [&](const auto& each) { return each.last >= from; });
  const auto first = std::min(static_cast<std::size_t>(found - all.begin()), all.size() - 1);
  auto end = first;
  while (end < all.size() && (size == 0 || size + all[end].size <= part.bytes))
    size += all[end++].size;
  return {first, end};
}

class PartReader {
public:
  explicit PartReader(const mcap::File& of) : file(of), layout(layoutOf(of)) {}

  std::expected<TraceOfPart, std::string> read(const PartOfRun& part) {
    const auto head = layout.metadata.find(std::string(kTraceHead));
    auto trace = head == layout.metadata.end() ? OrderedJson() : parsedJson(head->second);
    if (!trace.is_object())
      return std::unexpected("it was not recorded by `proskill run`, or by an older one");
    if (layout.stretches.empty()) return TraceOfPart{.text = textOf(trace, {})};
    const auto [first, end] = chosen(layout.stretches, part);
    for (auto i = first; i < end; ++i)
      bytes += file.readAtMost(layout.stretches[i].at, layout.stretches[i].size);
    const auto steps = messages("/steps");
    if (!steps) return std::unexpected(steps.error());
    auto made = placeOf(first, end);
    if (!made.isWhole) {
      const auto run = trace.value("description", "a recorded run");
      trace["part"] = {
          {"run", run}, {"begin", made.begin}, {"end", made.end}, {"length", made.length}};
      trace["description"] =
          fmt::format("{}: {:.6g} to {:.6g} s of {:.6g} s", run, made.begin, made.end, made.length);
    }
    if (first > 0) setValues(trace);
    made.text = textOf(trace, *steps);
    return made;
  }

private:
  using Messages = std::expected<std::vector<std::string_view>, std::string>;

  [[nodiscard]] Messages messages(std::string_view topic) const {
    const auto channel = layout.channels.find(std::string(topic));
    if (channel == layout.channels.end()) return Messages();
    return mcap::messagesIn(bytes, channel->second);
  }

  [[nodiscard]] double secondsAt(std::uint64_t time) const {
    return static_cast<double>(time - layout.stretches.front().first) / 1e9;
  }

  [[nodiscard]] TraceOfPart placeOf(std::size_t first, std::size_t end) const {
    const auto& all = layout.stretches;
    return {.text = {},
            .begin = secondsAt(all[first].first),
            .end = secondsAt(all[end - 1].last),
            .length = secondsAt(all.back().last),
            .isWhole = first == 0 && end == all.size()};
  }

  /// The values at the beginning of the part: the first messages in it.
  void setValues(OrderedJson& trace) const {
    for (const auto topic : {kVariablesTopic, kSkillsTopic}) {
      const auto all = messages(topic);
      if (!all || all->empty()) continue;
      const auto values = parsedJson(all->front());
      if (!values.is_object()) continue;
      const std::string suffix(topic == kSkillsTopic ? kStatusSuffix : "");
      for (const auto& [name, value] : values.items())
        trace["initial"][name + suffix] =
            value.is_string() ? value.get<std::string>() : value.dump();
    }
  }

  static std::string textOf(const OrderedJson& trace, const std::vector<std::string_view>& steps) {
    return traceWith(trace.dump(-1, ' ', false, OrderedJson::error_handler_t::replace), steps);
  }

  const mcap::File& file;
  mcap::Layout layout;
  std::string bytes; ///< of the part
};

} // namespace

std::expected<TraceOfPart, std::string> traceOfPart(const mcap::File& recording,
                                                    const PartOfRun& part) {
  try {
    return PartReader(recording).read(part);
  } catch (const OrderedJson::exception&) {
    return std::unexpected("it is damaged");
  }
}

std::string whyNotShown(const mcap::File& file, const std::string& reason) {
  constexpr std::uint64_t kLarge = std::uint64_t{256} << 20;
  if (file.size <= kLarge || file.read(0, 1) != "{") return reason;
  return reason + "; long runs are shown in parts if they are recorded as MCAP (`--record "
                  "run.mcap`), and `proskill conform` reads traces of any size";
}

} // namespace proskill::report
