#pragma once

#include "codegen/model.h"

#include <filesystem>
#include <string>
#include <vector>

/// What a user adds to the model of a program, written in Fiacre. The text becomes a file of the
/// program, so that diagnostics and traces can show its lines.
namespace proskill::ide {

/// Puts the process or component of a text in the place of the environment that was generated. Its
/// ports are events and interrupts of the program, by the names that they have in the model; those
/// that it has not never happen. Its parameters are variables of the model, by reference. The text
/// may declare types, constants, functions and further processes; which one is the environment says
/// the name at its end, or it is the last component, or the only process. A check of the states of
/// the old environment goes. \return what is wrong with it; the model means nothing then \pre the
/// model is one for verification
[[nodiscard]] std::vector<syntax::Diagnostic> replaceEnvironment(codegen::Model& model,
                                                                 analysis::Program& program,
                                                                 const std::filesystem::path& path,
                                                                 std::string text);

/// Adds the properties of a text, with a check for each that is asserted. Paths begin with the
/// model's main component, or with `model`; their steps are places in `par` or what the program
/// calls the process. Variables and values may have the names that the program gives them. The text
/// of a file `.ltl` is one formula, called as the file. \return what is wrong with it; the model
/// means nothing then
[[nodiscard]] std::vector<syntax::Diagnostic> addProperties(codegen::Model& model,
                                                            analysis::Program& program,
                                                            const std::filesystem::path& path,
                                                            std::string text);

} // namespace proskill::ide
