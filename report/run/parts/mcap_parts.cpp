#include "report/run/parts/run_parts.h"
#include "report/run/read_recording.h"

namespace proskill::report {

namespace {

class McapParts final : public RunParts {
public:
  explicit McapParts(const mcap::File& file) : layout(layoutOf(file)) {
    const auto head = layout.metadata.find(std::string(kTraceHead));
    if (head != layout.metadata.end()) trace = parsedJson(head->second);
    all = layout.stretches;
  }

  [[nodiscard]] std::expected<std::vector<std::string_view>, std::string>
  steps(std::string_view bytes) const override {
    return messages("/steps", bytes);
  }

  /// The first messages of a chunk have all values.
  [[nodiscard]] std::map<std::string, std::string> valuesAt(std::size_t,
                                                            std::string_view bytes) const override {
    std::map<std::string, std::string> found;
    for (const auto topic : {kVariablesTopic, kSkillsTopic}) {
      const auto all = messages(topic, bytes);
      if (!all || all->empty()) continue;
      const auto values = parsedJson(all->front());
      if (!values.is_object()) continue;
      const std::string suffix(topic == kSkillsTopic ? kStatusSuffix : "");
      for (const auto& [name, value] : values.items())
        found[name + suffix] = value.is_string() ? value.get<std::string>() : value.dump();
    }
    return found;
  }

private:
  [[nodiscard]] std::expected<std::vector<std::string_view>, std::string>
  messages(std::string_view topic, std::string_view bytes) const {
    const auto channel = layout.channels.find(std::string(topic));
    if (channel == layout.channels.end()) return std::vector<std::string_view>();
    return mcap::messagesIn(bytes, channel->second);
  }

  mcap::Layout layout;
};

} // namespace

FoundParts partsOfMcap(const mcap::File& file) {
  auto parts = std::make_unique<McapParts>(file);
  if (!parts->head().is_object())
    return std::unexpected("it was not recorded by `proskill run`, or by an older one");
  return parts;
}

} // namespace proskill::report
