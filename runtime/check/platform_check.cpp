#include "runtime/check/platform_check.h"

#include "analysis/flow/ignores.h"
#include "runtime/platform/ros.h"
#include "runtime/platform/settings.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <map>
#include <set>

namespace proskill::runtime {

namespace {

using codegen::PlatformInterface;
using syntax::Code;

/// Settings with room for what a platform file may say.
SimulationSettings roomFor(const PlatformInterface& interface) {
  SimulationSettings settings;
  for (const auto& performed : interface.performed)
    settings.actions.push_back({{}, {}, std::vector<unsigned>(performed.results.size())});
  settings.endings.resize(interface.performed.size());
  settings.signals.resize(interface.signals.size());
  return settings;
}

/// Notes the events of the program that none of these sensors reports.
void noteSilentEvents(const Json& mapping, const analysis::Program& program,
                      PlatformCheck& result) {
  std::set<std::string> reported;
  for (const auto& sensor : mapping["sensors"]) {
    if (sensor["silent"].is_string()) reported.insert(sensor["silent"]);
    for (const auto& each : sensor["cases"]) reported.insert(each["event"]);
  }
  for (const auto& event : program.events.all)
    if (std::string name(event.name()); !reported.contains(name))
      result.silentEvents.push_back(std::move(name));
}

FileErrors checkRos(const JsonFile& file, Ros ros, const analysis::Program& program,
                    const PlatformInterface& interface, PlatformCheck& result) {
  ProcessSettings settings;
  auto errors = readRosPlatform(file, ros, program, interface, settings);
  if (errors.empty()) noteSilentEvents(parsedText(settings.settings), program, result);
  return errors;
}

FileErrors checkKind(const PlatformFile& platform, const analysis::Program& program,
                     const PlatformInterface& interface, PlatformCheck& result) {
  switch (platform.kind) {
  case PlatformKind::Simulated: {
    auto settings = roomFor(interface);
    return readSimulation(platform.file, interface, settings);
  }
  case PlatformKind::Process: {
    ProcessSettings settings;
    return readProcessPlatform(platform.file, settings);
  }
  case PlatformKind::Library: {
    LibrarySettings settings;
    return readLibraryPlatform(platform.file, interface, settings);
  }
  case PlatformKind::Ros1: return checkRos(platform.file, Ros::One, program, interface, result);
  case PlatformKind::Ros2: return checkRos(platform.file, Ros::Two, program, interface, result);
  }
  return {};
}

syntax::Diagnostic diagnosticOf(const FileError& error, const analysis::Program& program,
                                const analysis::NamedPlatform& named) {
  const auto place = error.place ? ":" + error.place->text() : "";
  auto made =
      syntax::makeDiagnostic(Code::WrongPlatform, named.at, named.written, place, error.why);
  if (const auto* skill = program.skills.find(error.skill))
    made.related.push_back({skill->at((*skill)->name.range), "the skill"});
  return made;
}

syntax::Diagnostic silenceOf(const std::string& name, const analysis::Program& program,
                             const analysis::NamedPlatform& named) {
  auto made = syntax::makeDiagnostic(Code::SilentPlatform, named.at, named.written, name);
  const auto& event = *program.events.find(name);
  made.related.push_back({event.at(event->name.range), "the event"});
  return made;
}

/// Without an interface, for example because several skills could be the mission, the rest is
/// checked.
PlatformCheck checkFor(const analysis::Program& program, bool isSound, std::string_view text) {
  if (!isSound) return checkPlatform(text, program, nullptr);
  const auto interface = codegen::platformInterface(program);
  return checkPlatform(text, program, interface ? &*interface : nullptr);
}

std::vector<PlatformFinding> findingsOf(const analysis::Program& program, bool isSound,
                                        const analysis::NamedPlatform& named,
                                        const ReadFile& read) {
  const auto text = read(named.file);
  if (!text)
    return {
        {syntax::makeDiagnostic(Code::UnreadablePlatform, named.at, named.written, text.error()),
         named.file, text.error()}};
  const auto [errors, silentEvents] = checkFor(program, isSound, *text);
  std::vector<PlatformFinding> found;
  for (const auto& error : errors)
    found.push_back({diagnosticOf(error, program, named), named.file, error.why, error.place});
  for (const auto& name : silentEvents)
    found.push_back(
        {silenceOf(name, program, named), named.file, "it never reports the event `" + name + "`"});
  return found;
}

/// Gives findings the severities of the settings, and removes those that are ignored. Their
/// messages differ.
void weigh(std::vector<PlatformFinding>& found, const analysis::Program& program,
           const analysis::flow::Settings& settings) {
  namespace flow = analysis::flow;
  std::vector<syntax::Diagnostic> all;
  for (const auto& each : found) all.push_back(each.diagnostic);
  std::map<std::string, syntax::Diagnostic> left;
  for (auto& each : flow::withoutIgnored(program, flow::weighed(std::move(all), settings)))
    left.emplace(each.message, std::move(each));
  std::erase_if(found, [&](const auto& it) { return !left.contains(it.diagnostic.message); });
  for (auto& each : found) each.diagnostic = left.at(each.diagnostic.message);
}

} // namespace

PlatformCheck checkPlatform(std::string_view text, const analysis::Program& program,
                            const PlatformInterface* interface) {
  PlatformCheck result;
  const auto platform = PlatformFile::parse(text);
  if (!platform)
    result.errors = platform.error();
  else if (interface)
    result.errors = checkKind(*platform, program, *interface, result);
  return result;
}

std::vector<PlatformFinding> checkNamedPlatform(const analysis::Program& program, bool isSound,
                                                const analysis::flow::Settings& settings,
                                                const ReadFile& read) {
  const auto named = analysis::namedPlatform(program);
  if (!named) return {};
  auto found = findingsOf(program, isSound, *named, read);
  weigh(found, program, settings);
  return found;
}

} // namespace proskill::runtime
