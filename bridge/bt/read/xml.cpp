#include "bridge/bt/read/xml.h"

#include "bridge/bt/read/repair_xml.h"

#include <expat.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace proskill::bridge::bt {
namespace {

/// Builds elements from the calls of Expat.
class Reader {
public:
  /// \param encoding null: as the document says
  /// \param added bytes that are not in the file
  Reader(std::string_view text, const std::filesystem::path& file, const char* encoding,
         const std::vector<std::size_t>& added)
      : parser(XML_ParserCreate(encoding), XML_ParserFree), text(text), file(file), added(added) {
    XML_SetUserData(parser.get(), this);
    XML_SetElementHandler(parser.get(), &Reader::onStart, &Reader::onEnd);
    XML_SetCharacterDataHandler(parser.get(), &Reader::onText);
    XML_SetStartDoctypeDeclHandler(parser.get(), &Reader::onDoctype);
  }

  std::expected<Element, Error> read() {
    const auto status =
        XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
    if (error) return std::unexpected(*error);
    if (status != XML_STATUS_OK) return std::unexpected(Error{here(), reason()});
    return std::move(root.children.front());
  }

  /// Whether the document names an encoding that is unknown, or that it does not have.
  [[nodiscard]] bool isMisnamed() const {
    const auto code = XML_GetErrorCode(parser.get());
    return code == XML_ERROR_UNKNOWN_ENCODING || code == XML_ERROR_INCORRECT_ENCODING;
  }

private:
  static Reader& of(void* reader) { return *static_cast<Reader*>(reader); }

  static void onStart(void* reader, const char* name, const char** attributes) {
    of(reader).start(name, attributes);
  }
  static void onEnd(void* reader, const char* /*name*/) { of(reader).end(); }
  static void onText(void* reader, const char* text, int size) {
    of(reader).addText({text, static_cast<std::size_t>(size)});
  }
  static void onDoctype(void* reader, const char*, const char*, const char*, int) {
    of(reader).fail("a document type is not allowed here");
  }

  void start(const char* name, const char** attributes) {
    if (open.size() >= kDeepestXml) return fail("elements are nested too deeply");
    if (++count > kMostElements) return fail("the file has too many elements");
    Element element{.name = name, .place = here()};
    for (; *attributes != nullptr; attributes += 2)
      element.attributes.emplace_back(attributes[0], attributes[1]);
    open.push_back(std::move(element));
  }

  void end() {
    if (open.empty()) return; // after an error
    Element element = std::move(open.back());
    open.pop_back();
    (open.empty() ? root : open.back()).children.push_back(std::move(element));
  }

  void addText(std::string_view bytes) {
    if (open.empty() || bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
    if (!open.back().text) open.back().text = here();
  }

  void fail(const std::string& message) {
    if (!error) error = Error{here(), message};
    XML_StopParser(parser.get(), XML_FALSE);
  }

  Place here() {
    const auto column = static_cast<std::size_t>(XML_GetCurrentColumnNumber(parser.get()));
    const auto byte = static_cast<std::size_t>(XML_GetCurrentByteIndex(parser.get()));
    return {file, XML_GetCurrentLineNumber(parser.get()), column + 1 - addedBefore(byte)};
  }

  /// How many bytes were added to a line before this byte. Expat goes through the text in order.
  std::size_t addedBefore(std::size_t byte) {
    if (added.empty()) return 0;
    for (; seen < std::min(byte, text.size()); ++seen)
      if (text[seen] == '\n' || text[seen] == '\r') lineBegin = seen + 1;
    const auto first = std::ranges::lower_bound(added, std::min(lineBegin, byte));
    return static_cast<std::size_t>(std::ranges::lower_bound(added, byte) - first);
  }

  std::string reason() {
    return std::string("not well-formed XML: ") + XML_ErrorString(XML_GetErrorCode(parser.get()));
  }

  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser;
  std::string_view text;
  const std::filesystem::path& file;
  const std::vector<std::size_t>& added;
  std::size_t seen = 0;      ///< bytes of the text
  std::size_t lineBegin = 0; ///< of the line that they end with
  Element root;
  std::vector<Element> open;
  std::optional<Error> error;
  std::size_t count = 0;
};

} // namespace

const std::string* Element::attribute(std::string_view called) const {
  const auto found =
      std::ranges::find(attributes, called, &std::pair<std::string, std::string>::first);
  return found == attributes.end() ? nullptr : &found->second;
}

namespace {

std::expected<Element, Error> readAsNamed(std::string_view text, const std::filesystem::path& file,
                                          const std::vector<std::size_t>& added) {
  Reader asNamed(text, file, nullptr, added);
  auto root = asNamed.read();
  if (root || !asNamed.isMisnamed()) return root;
  auto inUtf8 = Reader(text, file, "UTF-8", added).read();
  return inUtf8 ? std::move(inUtf8) : std::move(root);
}

} // namespace

std::expected<Document, Error> readXml(std::string_view text, const std::filesystem::path& file) {
  if (text.size() > kLargestXml)
    return std::unexpected(Error{{file}, "the file is larger than 16 MiB"});
  auto root = readAsNamed(text, file, {});
  if (root) return Document{std::move(*root), true};
  if (text.contains('\0')) return std::unexpected(root.error()); // in UTF-16, `&` has two bytes
  const auto repaired = repairXml(text);
  if (repaired.text == text) return std::unexpected(root.error());
  auto again = readAsNamed(repaired.text, file, repaired.added);
  if (!again) return std::unexpected(again.error());
  return Document{std::move(*again), false};
}

} // namespace proskill::bridge::bt
