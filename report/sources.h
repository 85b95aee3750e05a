#pragma once

#include "analysis/program/program.h"
#include "report/ordered_json.h"

#include <expected>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// Which texts a trace is about: its places are lines of these, and may be wrong in later ones.
namespace proskill::report {

/// The digest of the text of a file, whether or not it begins with a byte order mark.
[[nodiscard]] std::string sourceDigest(std::string_view text);

/// The member `sources` of traces: the digest of each file of the program.
[[nodiscard]] OrderedJson sourcesJson(const analysis::Program& program);

/// The present text of a file, or why it cannot be read.
using TextOfFile = std::function<std::expected<std::string, std::string>(const std::string& file)>;

/// The files whose texts have changed since a trace was made. Older traces do not say which texts
/// they are about, and files that cannot be read have not changed. At most 1,000 files are read.
/// \param trace well-formed or not
[[nodiscard]] std::vector<std::string> editedSources(const OrderedJson& trace,
                                                     const TextOfFile& textOf);

} // namespace proskill::report
