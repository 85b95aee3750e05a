#pragma once

#include "codegen/model.h"

#include <map>
#include <string>
#include <string_view>

namespace proskill::test {

/// The model of a program in one text. Fails the test if the program has errors, or if a Fiacre
/// compiler would reject the model.
[[nodiscard]] codegen::Model modelOf(const std::string& text, const codegen::Options& options = {});

/// Why there is no model of it.
[[nodiscard]] codegen::GenerationError errorOf(const std::string& text,
                                               const codegen::Options& options = {});

/// The model's text as it is printed, without comments.
[[nodiscard]] std::string printed(const codegen::Model& model);
/// One process of that text.
[[nodiscard]] std::string printedProcess(const codegen::Model& model, std::string_view process);
/// One state of that text.
[[nodiscard]] std::string printedState(const codegen::Model& model, std::string_view process,
                                       std::string_view state);

[[nodiscard]] const fiacre::Process& processOf(const codegen::Model& model, std::string_view name);
[[nodiscard]] bool hasState(const fiacre::Process& process, std::string_view state);

/// The engine's verdict on each check: `holds`, `violated`, `reachable`, `unreachable`,
/// `inconclusive`.
[[nodiscard]] std::map<std::string, std::string> verdictsOf(const std::string& text,
                                                            const codegen::Options& options = {});

} // namespace proskill::test
