#include "report/run/mcap_writer.h"
#include "report/run/read_recording.h"
#include "report/run/run_json.h"
#include "report/run/run_lines.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <array>
#include <charconv>

namespace proskill::report {

using runtime::Nanoseconds;

namespace {

constexpr std::uint16_t kSteps = 1; ///< identifiers of channels, and of the schemas of their
                                    ///< messages
constexpr std::uint16_t kVariables = 2;
constexpr std::uint16_t kSkills = 3;

OrderedJson object(OrderedJson properties) {
  return {{"type", "object"}, {"properties", std::move(properties)}};
}

OrderedJson ofType(const char* type) { return {{"type", type}}; }

/// The members that all steps have; others are allowed.
OrderedJson stepSchema() {
  const auto seconds = object({{"exact", ofType("string")}, {"seconds", ofType("number")}});
  auto change = object(
      {{"variable", ofType("string")}, {"before", ofType("string")}, {"after", ofType("string")}});
  return object({{"actor", ofType("string")},
                 {"description", ofType("string")},
                 {"remark", ofType("string")},
                 {"message", ofType("string")},
                 {"date", seconds},
                 {"delay", seconds},
                 {"lag", ofType("number")},
                 {"stops", ofType("string")},
                 {"run", ofType("integer")},
                 {"changes", {{"type", "array"}, {"items", std::move(change)}}}});
}

/// Writes variables as a JSON object with strings and numbers.
class VariableWriter {
public:
  VariableWriter(const runtime::Executable& of, bool statuses) : system(of.system) {
    for (std::uint32_t i = 0; i < of.shownVariables; ++i)
      if (system.watched[i].display.ends_with(kStatusSuffix) == statuses) places.push_back(i);
    for (const auto place : places) {
      keys.push_back(dumped(name(place, statuses)) + ":");
      auto& all = words.emplace_back();
      for (const auto& word : system.watched[place].words) all.push_back(dumped(word));
    }
    for (const auto place : places)
      schema[name(place, statuses)] =
          ofType(system.watched[place].words.empty() ? "integer" : "string");
  }

  [[nodiscard]] bool isEmpty() const { return places.empty(); }
  [[nodiscard]] OrderedJson schemaJson() const { return object(schema); }

  [[nodiscard]] bool changed(const std::vector<verify::Word>& before,
                             const std::vector<verify::Word>& after) const {
    for (const auto place : places)
      if (value(place, before) != value(place, after)) return true;
    return false;
  }

  [[nodiscard]] const std::string& write(const std::vector<verify::Word>& state) {
    text = "{";
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i > 0) text += ',';
      text += keys[i];
      addValue(i, value(places[i], state));
    }
    return text += '}';
  }

private:
  void addValue(std::size_t place, std::int64_t value) {
    if (value >= 0 && static_cast<std::size_t>(value) < words[place].size()) {
      text += words[place][static_cast<std::size_t>(value)];
      return;
    }
    std::array<char, 24> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(digits.data(), end);
  }

  /// A status has the name of its skill.
  [[nodiscard]] std::string name(std::uint32_t place, bool isStatus) const {
    const auto& display = system.watched[place].display;
    return isStatus ? display.substr(0, display.size() - kStatusSuffix.size()) : display;
  }
  [[nodiscard]] std::int64_t value(std::uint32_t place,
                                   const std::vector<verify::Word>& state) const {
    return verify::readCell(system, system.watched[place].cell, state.data());
  }

  const verify::System& system;
  std::vector<std::uint32_t> places; ///< indices among the watched variables
  std::vector<std::string> keys;
  std::vector<std::vector<std::string>> words; ///< the values of each, as JSON
  OrderedJson schema = OrderedJson::object();
  std::string text;
};

class McapRecording final : public runtime::Observer {
public:
  McapRecording(RecordingSink to, RunSubject subject, std::uint64_t begin, std::size_t chunkSize)
      : file(std::move(to), chunkSize),
        lines(subject),
        variables(subject.executable, false),
        skills(subject.executable, true),
        start(begin) {
    file.addMetadata(kTraceHead, "json", dumped(runHeadJson(subject)));
    addChannel(kSteps, "proskill.Step", stepSchema(), "/steps");
    addChannel(kVariables, "proskill.Variables", variables.schemaJson(), kVariablesTopic);
    addChannel(kSkills, "proskill.Skills", skills.schemaJson(), kSkillsTopic);
    beginChunk(verify::initialState(subject.executable.system), 0);
    file.flush();
  }
  McapRecording(const McapRecording&) = delete;
  McapRecording& operator=(const McapRecording&) = delete;
  ~McapRecording() override { file.finish(); }

  void onStep(const runtime::Machine& machine, verify::TransitionId step, Nanoseconds date,
              Nanoseconds lag) override {
    if (file.isFull()) beginChunk(machine.stateBefore(), date);
    addMessage(kSteps, date, lines.step(machine, step, date, lag));
    if (variables.changed(machine.stateBefore(), machine.state()))
      addMessage(kVariables, date, variables.write(machine.state()));
    if (skills.changed(machine.stateBefore(), machine.state()))
      addMessage(kSkills, date, skills.write(machine.state()));
    file.flush();
  }

  void onRemark(const runtime::Remark& remark) override {
    addMessage(kSteps, remark.date, lines.remark(remark));
    file.flush();
  }

private:
  /// Begins a chunk with all values, so that it can be read without the chunks before.
  void beginChunk(const std::vector<verify::Word>& state, Nanoseconds date) {
    file.beginChunk();
    addMessage(kVariables, date, variables.write(state));
    addMessage(kSkills, date, skills.write(state));
  }

  void addChannel(std::uint16_t id, std::string_view name, const OrderedJson& schema,
                  std::string_view topic) {
    file.addChannel(id, name, dumped(schema), topic);
  }

  void addMessage(std::uint16_t channel, Nanoseconds date, std::string_view json) {
    file.addMessage(channel, start + static_cast<std::uint64_t>(date), json);
  }

  mcap::Writer file;
  RunLines lines;
  VariableWriter variables;
  VariableWriter skills;
  std::uint64_t start;
};

} // namespace

std::unique_ptr<runtime::Observer> runMcap(RecordingSink sink, RunSubject subject,
                                           std::uint64_t start, std::size_t chunkSize) {
  return std::make_unique<McapRecording>(std::move(sink), subject, start, chunkSize);
}

} // namespace proskill::report
