#include "rpc/json_writer.h"

#include <catch2/catch.hpp>

using namespace proskill;
using rpc::JsonWriter;

TEST_CASE("what is written is what the library writes") {
  const std::string odd = "a \"b\" \\ \n \x01 é 😀 \xff\xc3 \x7f";
  const Json json{{"text", odd},
                  {"empty", ""},
                  {"list", {1, -2, 3.5, true, nullptr}},
                  {"none", {}},
                  {"map", Json::object()},
                  {"large", 18446744073709551615U},
                  {"\"key\"", 1},
                  {"nested", {{"a", {{"b", Json::array({Json::array()})}}}}}};
  CHECK(rpc::dump(json) == json.dump(-1, ' ', false, Json::error_handler_t::replace));
  CHECK(rpc::dump(odd) == Json(odd).dump(-1, ' ', false, Json::error_handler_t::replace));
  CHECK(rpc::dump(nullptr) == "null");
}

TEST_CASE("text that is JSON already stands among values as it is") {
  JsonWriter text;
  text.open('{').member("line", 3U).member("at", -1).member("name", "x").member("is", true);
  text.key("list").open('[').value(1).value("[").open('[').close(']').close(']').close('}');
  CHECK(text.str() == R"({"line":3,"at":-1,"name":"x","is":true,"list":[1,"[",[]]})");
  const Json json{{"a", rpc::written(text.str())}, {"b", Json::array({rpc::written("1"), 2})}};
  CHECK(rpc::dump(json) == R"({"a":)" + text.str() + R"(,"b":[1,2]})");
  CHECK(rpc::sizeOf(json) >= text.str().size());
}

TEST_CASE("messages have their parts in the protocol's form") {
  CHECK(Json::parse(rpc::request("p-1", "m", {{"a", 1}})) ==
        Json{{"jsonrpc", "2.0"}, {"id", "p-1"}, {"method", "m"}, {"params", {{"a", 1}}}});
  CHECK(Json::parse(rpc::reply(7, rpc::written("[1]"))) ==
        Json{{"jsonrpc", "2.0"}, {"id", 7}, {"result", {1}}});
  const auto error = Json::parse(rpc::replyError(nullptr, {rpc::ErrorCode::ParseError, "\xff", 1}));
  CHECK(error["error"] == Json{{"code", -32700}, {"message", "\xef\xbf\xbd"}, {"data", 1}});
}
