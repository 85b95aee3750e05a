#pragma once

#include "codegen/model.h"

#include <filesystem>
#include <string>
#include <vector>

/// Additions to a program's model that a user writes in Fiacre. The text becomes a file of the
/// program, so that diagnostics and traces can show its lines.
namespace proskill::ide {

/// Replaces the generated environment by the process or component of a text. Its ports are events
/// and interrupts of the program, with their names in the model; events that it does not mention
/// never happen. Its parameters are variables of the model, passed by reference. The text may
/// declare types, constants, functions and other processes. The environment is the one named at its
/// end; otherwise the last component, or the only process. Checks about states of the old
/// environment are removed.
/// \return diagnostics; if there are any, the model is undefined
/// \pre the model is one for verification
[[nodiscard]] std::vector<syntax::Diagnostic> replaceEnvironment(codegen::Model& model,
                                                                 analysis::Program& program,
                                                                 const std::filesystem::path& path,
                                                                 std::string text);

/// Adds the properties of a text, with a check for each asserted one. Paths begin with the model's
/// main component or with `model`; their steps are positions in `par` or the program's names of
/// processes. Variables and values may have their names in the program. The text of a file `.ltl`
/// is a single formula, named after the file.
/// \return diagnostics; if there are any, the model is undefined
[[nodiscard]] std::vector<syntax::Diagnostic> addProperties(codegen::Model& model,
                                                            analysis::Program& program,
                                                            const std::filesystem::path& path,
                                                            std::string text);

} // namespace proskill::ide
