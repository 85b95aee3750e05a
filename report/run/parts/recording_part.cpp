#include "report/run/parts/recording_part.h"

#include "report/run/lines.h"
#include "report/run/parts/run_parts.h"
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
  PartReader(const mcap::File& of, const RunParts& in) : file(of), parts(in) {}

  std::expected<TraceOfPart, std::string> read(const PartOfRun& part) {
    auto trace = parts.head();
    if (parts.stretches().empty()) return TraceOfPart{.text = textOf(trace, {})};
    const auto [first, end] = chosen(parts.stretches(), part);
    for (auto i = first; i < end; ++i)
      bytes += file.readAtMost(parts.stretches()[i].at, parts.stretches()[i].size);
    const auto steps = parts.steps(bytes);
    if (!steps) return std::unexpected(steps.error());
    auto made = placeOf(first, end);
    if (!made.isWhole) {
      const auto run = trace.value("description", "a recorded run");
      trace["part"] = {
          {"run", run}, {"begin", made.begin}, {"end", made.end}, {"length", made.length}};
      trace["description"] =
          fmt::format("{}: {:.6g} to {:.6g} s of {:.6g} s", run, made.begin, made.end, made.length);
    }
    if (first > 0)
      for (const auto& [name, value] : parts.valuesAt(first, bytes)) trace["initial"][name] = value;
    made.text = textOf(trace, *steps);
    return made;
  }

private:
  [[nodiscard]] double secondsAt(std::uint64_t time) const {
    return static_cast<double>(time - parts.stretches().front().first) / 1e9;
  }

  [[nodiscard]] TraceOfPart placeOf(std::size_t first, std::size_t end) const {
    const auto& all = parts.stretches();
    return {.text = {},
            .begin = secondsAt(all[first].first),
            .end = secondsAt(all[end - 1].last),
            .length = secondsAt(all.back().last),
            .isWhole = first == 0 && end == all.size()};
  }

  static std::string textOf(const OrderedJson& trace, const std::vector<std::string_view>& steps) {
    return traceWith(trace.dump(-1, ' ', false, OrderedJson::error_handler_t::replace), steps);
  }

  const mcap::File& file;
  const RunParts& parts;
  std::string bytes; ///< of the part
};

/// Whether a file is too large to be shown as a whole.
bool isLarge(const mcap::File& file) { return file.size > std::uint64_t{256} << 20; }

} // namespace

bool isShownInParts(const mcap::File& file, const PartOfRun& part) {
  if (file.isMcap()) return true;
  if (!part.from && !isLarge(file)) return false;
  try {
    return headOfLines(Lines(file).next().value_or("")).has_value();
  } catch (const WrongRecording&) {
    return false;
  }
}

std::expected<TraceOfPart, std::string> traceOfPart(const mcap::File& recording,
                                                    const PartOfRun& part) {
  try {
    const auto parts = recording.isMcap() ? partsOfMcap(recording) : partsOfTrace(recording);
    if (!parts) return std::unexpected(parts.error());
    return PartReader(recording, **parts).read(part);
  } catch (const OrderedJson::exception&) {
    return std::unexpected("it is damaged");
  }
}

std::string whyNotShown(const mcap::File& file, const std::string& reason) {
  if (!isLarge(file) || file.read(0, 1) != "{") return reason;
  return reason + "; long runs are shown in parts if they have a step in each line, as "
                  "`proskill run --record` writes them";
}

} // namespace proskill::report
