#pragma once

#include "analysis/program/program.h"
#include "viz/pictures.h"
#include "viz/render.h"

#include <nlohmann/json.hpp>

#include <expected>
#include <optional>
#include <string>
#include <vector>

/// Parts of the panel's requests and answers (panel/src/api.ts); locations are as in
/// docs/verify.schema.json.
namespace proskill::view {

struct PictureParams {
  viz::Request request;
  viz::Format format = viz::Format::Svg;
  bool dark = false;
  /// Keys of clusters; nullopt: chosen by the size of the picture.
  std::optional<std::vector<std::string>> fold;
};

/// Parses parameters in the panel's format. The error is a message.
[[nodiscard]] std::expected<PictureParams, std::string>
readPictureParams(const nlohmann::ordered_json& params);

[[nodiscard]] nlohmann::ordered_json paramsJson(const PictureParams& params);

/// The picture with descriptions of its parts. \param errors whether the program has errors
[[nodiscard]] std::expected<nlohmann::ordered_json, std::string>
pictureJson(const analysis::Program& program, const PictureParams& params, bool errors);

/// All pictures of the program, to choose from.
[[nodiscard]] nlohmann::ordered_json picturesJson(const analysis::Program& program);

/// The text of one of its files.
[[nodiscard]] std::expected<nlohmann::ordered_json, std::string>
sourceJson(const analysis::Program& program, const std::string& uri);

/// Its files, the root first.
[[nodiscard]] nlohmann::ordered_json filesJson(const analysis::Program& program);

} // namespace proskill::view
