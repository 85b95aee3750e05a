#pragma once

#include "codegen/model.h"

#include <map>
#include <string>
#include <string_view>

namespace proskill::test {

/// The model of a program that is one text. Fails the test where the program has errors, or where a
/// Fiacre compiler would refuse the model.
[[nodiscard]] codegen::Model modelOf(const std::string& text, const codegen::Options& options = {});

/// Why there is no model of it.
[[nodiscard]] codegen::GenerationError errorOf(const std::string& text,
                                               const codegen::Options& options = {});

/// The model's text as it is printed, comments removed.
[[nodiscard]] std::string printed(const codegen::Model& model);
/// Of that: one process, from its name to the next one's.
[[nodiscard]] std::string printedProcess(const codegen::Model& model, std::string_view process);
/// Of that: what can happen in one state.
[[nodiscard]] std::string printedState(const codegen::Model& model, std::string_view process,
                                       std::string_view state);

[[nodiscard]] const fiacre::Process& processOf(const codegen::Model& model, std::string_view name);
[[nodiscard]] bool hasState(const fiacre::Process& process, std::string_view state);

/// What the engine answers to each check, in a user's words: `holds`, `violated`, `reachable`,
/// `unreachable`, `inconclusive`.
[[nodiscard]] std::map<std::string, std::string> verdictsOf(const std::string& text,
                                                            const codegen::Options& options = {});

} // namespace proskill::test
