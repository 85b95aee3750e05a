#pragma once

#include "rpc/rpc.h"
#include "viz/fold.h"
#include "viz/pictures.h"

#include <expected>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// Pictures for the language server and the panel's hosts: `Automaton` in docs/lsp.md.
namespace proskill::report {

/// Keys of clusters to draw as one node each; nullopt: chosen by the size of the picture.
using FoldKeys = std::optional<std::vector<std::string>>;

/// A picture and its folded clusters.
struct DrawnPicture {
  viz::Request request;
  viz::Graph whole;
  viz::Folded folded;
  bool foldedForSize = false; ///< without a request to fold
};

[[nodiscard]] std::expected<DrawnPicture, std::string>
drawPicture(const analysis::Program& program, const viz::Request& request, const FoldKeys& fold);

/// Returns a location in the client's format; null if it is in no text.
using PlaceJson = std::function<Json(const viz::Source&)>;

/// The members that describe the picture, from `kind` to `foldable`, without its content.
[[nodiscard]] Json pictureJson(const DrawnPicture& picture, const PlaceJson& place);

/// All pictures of the program, to choose from.
[[nodiscard]] Json picturesJson(const analysis::Program& program);

} // namespace proskill::report
