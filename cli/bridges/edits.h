#pragma once

#include "bridge/text/place.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace proskill::cli {

/// An imported program with a comment at its end: a digest of each definition and of the comments
/// before it, by which another import notices what was edited.
[[nodiscard]] std::string withDigests(const std::string& imported);

/// Errors for what somebody has added to an imported program, edited in it or removed from it,
/// which another import would undo. What the new text has is kept. White space does not count. A
/// file without digests is replaced only if it is empty or equal to the new text. \param imported
/// the new text, without digests \param path of the existing program
[[nodiscard]] bridge::Errors editsIn(const std::string& existing, const std::string& imported,
                                     const std::filesystem::path& path);

} // namespace proskill::cli
