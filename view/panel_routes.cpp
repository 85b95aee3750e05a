#include "view/panel_routes.h"

#include "report/ordered_json.h"
#include "view/panel_bundle.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <random>

namespace proskill::view {

namespace {

using Reply = std::function<void(HttpResponse)>;

constexpr std::string_view kPage = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="UTF-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>ProSkill</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="panel.css">
</head>
<body><div id="panel"></div><script src="panel.js"></script></body>
</html>
)";

constexpr std::string_view kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src blob: "
    "data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

HttpResponse refuse(int status, std::string why) {
  return {status, "text/plain; charset=utf-8", std::move(why) + "\n", {}};
}

/// Compares in constant time, so that a wrong token reveals nothing.
bool equal(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  return difference == 0;
}

/// Whether the request has our host and origin. Other pages may reach this machine by a name of
/// their own (DNS rebinding), or send requests to it.
bool isFromHere(const HttpRequest& request, std::uint16_t port) {
  const std::array hosts{fmt::format("127.0.0.1:{}", port), fmt::format("localhost:{}", port)};
  const auto isOurs = [&](std::string_view host) { return std::ranges::count(hosts, host) > 0; };
  const auto origin = request.header("origin");
  constexpr std::string_view scheme = "http://";
  if (!isOurs(request.header("host"))) return false;
  if (request.header("sec-fetch-site") == "cross-site") return false;
  return origin.empty() || (origin.starts_with(scheme) && isOurs(origin.substr(scheme.size())));
}

/// The beginning of the part of a recording; nullopt: the last part.
std::optional<double> secondsFrom(const OrderedJson& params) {
  const auto from = params.find("from");
  if (from == params.end() || !from->is_number()) return std::nullopt;
  return from->get<double>();
}

PanelData::Answer call(std::string_view method, const OrderedJson& params, PanelData& data) {
  const auto text = [&](const char* name) { return params.value(name, std::string()); };
  if (method == "hello")
    return OrderedJson{{"contract", 1},
                       {"layout", "all"},
                       {"can",
                        {{"source", true},
                         {"save", false},
                         {"open", false},
                         {"verify", data.canVerify()},
                         {"simulate", data.canSimulate()},
                         {"follow", false}}},
                       {"program", data.program()},
                       {"run", data.run()}};
  if (method == "trace") return data.trace(text("name"));
  if (method == "part") return data.part(secondsFrom(params));
  if (method == "source") return data.source(text("uri"));
  if (method == "simulate") return data.simulate(params);
  if (method == "steps") return data.steps(params);
  if (method == "control") return data.control(params);
  if (method == "verify") {
    data.verify();
    return OrderedJson();
  }
  if (method != "picture") return std::unexpected("there is no such request");
  const auto picture = readPictureParams(params);
  if (!picture) return std::unexpected(picture.error());
  return data.picture(*picture);
}

HttpResponse jsonResponse(const OrderedJson& reply) {
  return {200,
          "application/json",
          reply.dump(-1, ' ', false, OrderedJson::error_handler_t::replace),
          {}};
}

/// \return nullopt for a request for events, which is answered later
std::optional<HttpResponse> callJson(std::string_view method, const HttpRequest& request,
                                     PanelData& data, EventFeed& news, const Reply& reply) {
  if (!request.header("content-type").starts_with("application/json"))
    return refuse(400, "requests are JSON");
  const auto params = parsedJson(request.body);
  if (!params.is_object()) return refuse(400, "parameters must be a JSON object");
  try {
    if (method == "news") {
      news.after(params.value("after", std::size_t{0}), [reply](OrderedJson told) {
        reply(jsonResponse({{"result", std::move(told)}}));
      });
      return std::nullopt;
    }
    auto result = call(method, params, data);
    return jsonResponse(result ? OrderedJson{{"result", std::move(*result)}}
                               : OrderedJson{{"error", result.error()}});
  } catch (const OrderedJson::exception&) {
    return refuse(400, "a parameter is of the wrong type");
  }
}

} // namespace

std::string PanelAddress::url() const {
  return fmt::format("http://127.0.0.1:{}/{}/", port, token);
}

std::string randomToken() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", random());
  return token;
}

namespace {

HttpResponse file(std::string_view path) {
  if (path.empty())
    return {200,
            "text/html; charset=utf-8",
            std::string(kPage),
            {{"Content-Security-Policy", std::string(kPolicy)}}};
  if (path == "panel.js")
    return {200, "text/javascript; charset=utf-8", std::string(bundle::panelJs), {}};
  if (path == "panel.css")
    return {200, "text/css; charset=utf-8", std::string(bundle::panelCss), {}};
  return refuse(404, "there is nothing of this name");
}

std::optional<HttpResponse> answerNow(const HttpRequest& request, const PanelAddress& address,
                                      PanelData& data, EventFeed& news, const Reply& reply) {
  if (!isFromHere(request, address.port)) return refuse(403, "not for this host or origin");
  std::string_view path = request.target;
  path = path.substr(0, path.find('?'));
  const auto end = path.find('/', 1);
  if (end == std::string_view::npos || !equal(path.substr(1, end - 1), address.token))
    return refuse(403, "the address lacks the token that `proskill view` printed");
  path.remove_prefix(end + 1);
  if (path.starts_with("api/")) {
    if (request.method != "POST") return refuse(405, "requests must use POST");
    return callJson(path.substr(4), request, data, news, reply);
  }
  if (request.method != "GET" && request.method != "HEAD") return refuse(405, "read-only");
  return file(path);
}

} // namespace

void answer(const HttpRequest& request, const PanelAddress& address, PanelData& data,
            EventFeed& news, const Reply& reply) {
  if (auto response = answerNow(request, address, data, news, reply)) reply(std::move(*response));
}

} // namespace proskill::view
