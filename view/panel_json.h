#pragma once

#include "analysis/program/program.h"
#include "viz/pictures.h"
#include "viz/render.h"

#include <nlohmann/json.hpp>

#include <expected>
#include <optional>
#include <string>
#include <vector>

/// Parts of what the panel asks for (panel/src/api.ts), with places as docs/verify.schema.json has
/// them.
namespace proskill::view {

struct PictureParams {
  viz::Request request;
  viz::Format format = viz::Format::Svg;
  bool dark = false;
  /// Keys of clusters; nothing: as is best for the size of the picture.
  std::optional<std::vector<std::string>> fold;
};

/// Of the panel's form. What is wrong with it is the error.
[[nodiscard]] std::expected<PictureParams, std::string>
readPictureParams(const nlohmann::ordered_json& params);

[[nodiscard]] nlohmann::ordered_json paramsJson(const PictureParams& params);

/// The picture with what its parts mean. `errors`: the program has some.
[[nodiscard]] std::expected<nlohmann::ordered_json, std::string>
pictureJson(const analysis::Program& program, const PictureParams& params, bool errors);

/// All pictures of the program, to choose from.
[[nodiscard]] nlohmann::ordered_json picturesJson(const analysis::Program& program);

/// Its files, the root first.
[[nodiscard]] nlohmann::ordered_json filesJson(const analysis::Program& program);

} // namespace proskill::view
