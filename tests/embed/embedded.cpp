#include "tests/embed/embedded.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

namespace proskill::test {

namespace {

std::string withoutFolder(std::string text, const TemporaryDirectory& folder) {
  for (auto at = text.find(folder.path()); at != text.npos; at = text.find(folder.path()))
    text.erase(at, folder.path().size() + 1);
  return text;
}

} // namespace

Embedded::Embedded(const std::string& text, proskill_options options) {
  const auto file = files.write("mission.proskill", text);
  INFO(proskill_error_text());
  REQUIRE(proskill_program_load(file.c_str(), &program) == PROSKILL_OK);
  REQUIRE(proskill_executor_new(program, &options, &executor) == PROSKILL_OK);
  REQUIRE(proskill_executor_observe(executor, observe, this) == PROSKILL_OK);
}

Embedded::Embedded(const std::string& text, const std::string& platform,
                   const proskill_options* options) {
  files.write("robot.json", platform);
  REQUIRE(proskill_program_load(files.write("mission.proskill", text).c_str(), &program) ==
          PROSKILL_OK);
  made = proskill_executor_new(program, options, &executor);
  if (executor) REQUIRE(proskill_executor_observe(executor, observe, this) == PROSKILL_OK);
}

Embedded::~Embedded() {
  proskill_executor_free(executor);
  proskill_program_free(program);
}

proskill_options Embedded::simulated() {
  proskill_options options = PROSKILL_OPTIONS;
  options.clock = PROSKILL_SIMULATED_TIME;
  return options;
}

void Embedded::perform(const std::string& skill, Scripted action) {
  auto& kept = scripted[skill] = std::move(action);
  REQUIRE(proskill_executor_perform(executor, skill.c_str(), begin, stop, &kept) == PROSKILL_OK);
}

proskill_error Embedded::performBy(const char* skill, proskill_begin by, proskill_stop stopBy) {
  return proskill_executor_perform(executor, skill, by, stopBy, this);
}

std::string Embedded::value(const char* name) const {
  const char* text = nullptr;
  return proskill_executor_value(executor, name, &text) == PROSKILL_OK ? text
                                                                       : proskill_error_text();
}

std::string Embedded::error() const { return withoutFolder(proskill_error_text(), files); }

void Embedded::begin(proskill_executor* in, proskill_run run, const proskill_value*, size_t,
                     void* data) {
  const auto& action = *static_cast<const Scripted*>(data);
  if (!action.result.empty())
    proskill_executor_finish_after(in, run, action.seconds, action.result.c_str());
}

void Embedded::stop(proskill_executor* in, proskill_run run, void*) {
  proskill_executor_finish(in, run, PROSKILL_STOPPED);
}

void Embedded::observe(proskill_executor*, const proskill_entry* entry, void* data) {
  static_cast<Embedded*>(data)->happened += fmt::format(
      "{:.6g} {}{}: {}\n", entry->time, entry->is_fault ? "! " : "", entry->subject, entry->text);
}

std::string loadError(const std::string& text, proskill_error code) {
  const TemporaryDirectory files;
  const auto file = files.write("mission.proskill", text);
  proskill_program* program = nullptr;
  CHECK(proskill_program_load(file.c_str(), &program) == code);
  CHECK(program == nullptr);
  return withoutFolder(proskill_error_text(), files);
}

} // namespace proskill::test
