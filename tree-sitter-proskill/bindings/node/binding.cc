#include <napi.h>

typedef struct TSLanguage TSLanguage;

extern "C" TSLanguage *tree_sitter_proskill();

// What tree-sitter's own module looks for on a language: the first halves of two UUIDs it chose.
constexpr napi_type_tag kLanguageTypeTag = {0x8AF2E5212AD58ABF, 0xD5006CAD83ABBA16};

static Napi::Object Init(Napi::Env env, Napi::Object exports) {
  exports["name"] = Napi::String::New(env, "proskill");
  auto language = Napi::External<TSLanguage>::New(env, tree_sitter_proskill());
  language.TypeTag(&kLanguageTypeTag);
  exports["language"] = language;
  return exports;
}

NODE_API_MODULE(tree_sitter_proskill_binding, Init)
