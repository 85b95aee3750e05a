#include "view/panel_json.h"

#include "report/picture_json.h"
#include "report/text/source_place.h"

#include <map>

namespace proskill::view {

namespace {

/// Places of parts of pictures, in the form of docs/verify.schema.json.
class Places {
public:
  explicit Places(const analysis::Program& shown) : places(shown) {
    for (std::size_t i = 0; i < shown.files.size(); ++i)
      files[shown.files[i].path.string()] = static_cast<syntax::FileId>(i);
  }

  [[nodiscard]] Json operator()(const viz::Source& source) {
    const auto found = files.find(source.file);
    if (found == files.end()) return nullptr;
    const auto at = [&](syntax::Offset offset) {
      const auto it = places.at(found->second, offset);
      return Json{{"line", it.line}, {"column", it.column}};
    };
    return {{"file", places.path(found->second)},
            {"begin", at(source.range.begin)},
            {"end", at(source.range.end)}};
  }

private:
  report::SourcePlaces places;
  std::map<std::string, syntax::FileId> files;
};

} // namespace

std::expected<PictureParams, std::string> readPictureParams(const OrderedJson& params) {
  PictureParams out;
  try {
    const auto kind = viz::kindOf(params.at("kind").get_ref<const std::string&>());
    if (!kind) return std::unexpected("there are no pictures of this kind");
    out.request = {*kind, params.at("name").get<std::string>(), params.value("forbidden", false)};
    out.dark = params.value("dark", false);
    if (params.value("format", "svg") == "dot") out.format = viz::Format::Dot;
    if (params.contains("fold")) out.fold = params["fold"].get<std::vector<std::string>>();
  } catch (const OrderedJson::exception&) {
    return std::unexpected("not the parameters of a picture");
  }
  return out;
}

OrderedJson paramsJson(const PictureParams& params) {
  OrderedJson json{{"kind", viz::wordOf(params.request.kind)},
                   {"name", params.request.name},
                   {"dark", params.dark},
                   {"forbidden", params.request.forbidden}};
  if (params.fold) json["fold"] = *params.fold;
  return json;
}

std::expected<OrderedJson, std::string> pictureJson(const analysis::Program& program,
                                                    const PictureParams& params, bool errors) {
  const auto picture = report::drawPicture(program, params.request, params.fold);
  if (!picture) return std::unexpected(picture.error());
  auto content = viz::render(picture->folded.graph, params.format,
                             params.dark ? viz::Scheme::Dark : viz::Scheme::Light);
  if (!content) return std::unexpected(content.error());
  OrderedJson json = report::pictureJson(*picture, Places(program));
  json["content"] = std::move(*content);
  json["errors"] = errors;
  return json;
}

OrderedJson picturesJson(const analysis::Program& program) { return report::picturesJson(program); }

std::expected<OrderedJson, std::string> sourceJson(const analysis::Program& program,
                                                   const std::string& uri) {
  for (const auto& file : program.files)
    if (file.path.generic_string() == uri)
      return OrderedJson{{"uri", uri}, {"text", file.document.text()}};
  return std::unexpected("the program has no file of this name");
}

OrderedJson filesJson(const analysis::Program& program) {
  OrderedJson all = OrderedJson::array();
  for (const auto& file : program.files)
    all.push_back(
        {{"uri", file.path.generic_string()}, {"label", file.path.filename().generic_string()}});
  return all;
}

} // namespace proskill::view
