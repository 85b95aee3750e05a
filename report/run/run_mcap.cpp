#include "report/run/mcap.h"
#include "report/run/run_json.h"
#include "report/run/run_lines.h"
#include "verify/compile/watch.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

namespace proskill::report {

using runtime::Nanoseconds;

namespace {

constexpr std::string_view kStatus = ".status";
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
      if (system.watched[i].display.ends_with(kStatus) == statuses) places.push_back(i);
    for (const auto place : places) keys.push_back(dumped(name(place, statuses)) + ":");
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
      const auto& watched = system.watched[places[i]];
      const auto shown = verify::shown(watched, value(places[i], state));
      text += watched.words.empty() ? shown : dumped(shown);
    }
    return text += '}';
  }

private:
  /// A status has the name of its skill.
  [[nodiscard]] std::string name(std::uint32_t place, bool isStatus) const {
    const auto& display = system.watched[place].display;
    return isStatus ? display.substr(0, display.size() - kStatus.size()) : display;
  }
  [[nodiscard]] std::int64_t value(std::uint32_t place,
                                   const std::vector<verify::Word>& state) const {
    return verify::readCell(system, system.watched[place].cell, state.data());
  }

  const verify::System& system;
  std::vector<std::uint32_t> places; ///< indices among the watched variables
  std::vector<std::string> keys;
  OrderedJson schema = OrderedJson::object();
  std::string text;
};

class McapRecording final : public runtime::Observer {
public:
  McapRecording(AddToRecording to, RunSubject subject, std::uint64_t begin)
      : add(std::move(to)),
        lines(subject),
        variables(subject.executable, false),
        skills(subject.executable, true),
        start(begin),
        end(mcap::tail()) {
    mcap::addHead(bytes);
    addChannel(kSteps, "proskill.Step", stepSchema(), "/steps");
    addChannel(kVariables, "proskill.Variables", variables.schemaJson(), "/variables");
    addChannel(kSkills, "proskill.Skills", skills.schemaJson(), "/skills");
    const auto initial = verify::initialState(subject.executable.system);
    addMessage(kVariables, 0, variables.write(initial));
    addMessage(kSkills, 0, skills.write(initial));
    flush();
  }

  void onStep(const runtime::Machine& machine, verify::TransitionId step, Nanoseconds date,
              Nanoseconds lag) override {
    addMessage(kSteps, date, lines.step(machine, step, date, lag));
    if (variables.changed(machine.stateBefore(), machine.state()))
      addMessage(kVariables, date, variables.write(machine.state()));
    if (skills.changed(machine.stateBefore(), machine.state()))
      addMessage(kSkills, date, skills.write(machine.state()));
    flush();
  }

  void onRemark(const runtime::Remark& remark) override {
    addMessage(kSteps, remark.date, lines.remark(remark));
    flush();
  }

private:
  void addChannel(std::uint16_t id, std::string_view name, const OrderedJson& schema,
                  std::string_view topic) {
    mcap::addSchema(bytes, id, name, dumped(schema));
    mcap::addChannel(bytes, id, id, topic);
  }

  void addMessage(std::uint16_t channel, Nanoseconds date, std::string_view json) {
    mcap::addMessage(bytes, channel, sequence++, start + static_cast<std::uint64_t>(date), json);
  }

  void flush() {
    add(bytes, end);
    bytes.clear();
  }

  AddToRecording add;
  RunLines lines;
  VariableWriter variables;
  VariableWriter skills;
  std::uint64_t start;
  std::string end;
  std::uint32_t sequence = 0;
  std::string bytes;
};

} // namespace

std::unique_ptr<runtime::Observer> runMcap(AddToRecording add, RunSubject subject,
                                           std::uint64_t start) {
  return std::make_unique<McapRecording>(std::move(add), subject, start);
}

} // namespace proskill::report
