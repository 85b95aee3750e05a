#include "fiacre/format/line_builder.h"
#include "fiacre/print/writer.h"
#include "fiacre/syntax/words.h"

namespace proskill::fiacre {
namespace {

using Shape = FormatLine::Shape;

/// Tokens before an expression: `[]` after them is an empty array.
constexpr auto kBeforeExpression =
    std::to_array<std::string_view>({":=", ",", "=", "<>", "!", "?", ":", "return", "on", "where",
                                     "not", "and", "or", "case", "if", "while", "elsif"});

/// Breaks lines according to the structure of a model.
class Splitter final : LineBuilder {
public:
  Splitter(std::string_view read, const std::vector<Token>& tokens) : LineBuilder(read, tokens) {}

  std::vector<FormatLine> run() {
    while (peek().kind != TokenKind::End) step();
    ended = true;
    takeComments();
    return std::move(lines);
  }

private:
  enum class Block : std::uint8_t { Body, If, Select, Case, Loop };
  struct Frame {
    Block block;
    std::size_t indent;
  };

  void step() {
    if (depth > 0) return take();
    if (isAtDeclaration()) return declaration();
    if (isAtEntry()) return entry();
    if (isAt("par") && !frames.empty()) frames.clear();
    if (head) return takeHead();
    if (isAtSection()) return section();
    if (compositions > 0) return composition();
    if (inFunction && frames.empty() && isAt("return")) { // a body without `begin`
      ended = true;
      frames.push_back({Block::Body, 0});
    }
    if (!frames.empty()) return statement();
    take();
  }

  // --- Declarations and their parts
  [[nodiscard]] bool isAtDeclaration() const {
    return peek().kind == TokenKind::Name && beginsDeclaration(peek(), peek(1), peek(2)) &&
           !(previous() && previous()->text == "/");
  }

  [[nodiscard]] bool isAtEntry() const {
    if (peek().kind != TokenKind::Name || isReserved(peek().text) || !previous()) return false;
    const bool last = peek(1).kind == TokenKind::End ||
                      beginsDeclaration(peek(1), peek(2), peek(3)) || isAt(">", 1) || isAt(">", 2);
    const Token& before = *previous();
    const bool behindAll = before.kind == TokenKind::Number || before.kind == TokenKind::String ||
                           !isReserved(before.text);
    const bool named = before.kind != TokenKind::Symbol || before.text == ")" || before.text == "]";
    const bool behindBlock = before.text == "end" || before.text == "par";
    return last && ((behindAll && named) || behindBlock);
  }

  void declaration() {
    const auto word = peek().text;
    attached = false;
    frames.clear();
    compositions = 0;
    inFunction = word == "function";
    head = word == "process" || word == "component" || word == "function";
    start(0);
    auto& line = lines.back();
    if (head) separate();
    if (word == "process" || word == "component") line.shape = Shape::Head;
    if (word == "process" || word == "component" || word == "event" || word == "task" ||
        word == "extern" || word == "function")
      line.kind = LineKind::Head;
    if (word == "property" || word == "assert" || word == "prove") line.kind = LineKind::Property;
    if (word == "type") line.shape = Shape::Type;
    take();
  }

  /// The model's name, or `observer > model`; several of these may follow each other.
  void entry() {
    const bool attaches = isAt(">", 1);
    frames.clear();
    start(0);
    if (!attaches || !attached) separate();
    attached = attaches;
    take();
    for (int i = 0; attaches && i < 2; ++i) take();
    ended = true;
  }

  void takeHead() {
    head = !isAt("is");
    take();
    ended = !head;
  }

  [[nodiscard]] bool isAtSection() const {
    constexpr auto kSections = std::to_array<std::string_view>(
        {"states", "var", "port", "priority", "init", "begin", "from", "par"});
    return isAmong(peek().text, kSections);
  }

  void section() {
    const auto word = peek().text;
    if (word == "par") return openComposition();
    frames.clear();
    start(word == "var" && inFunction ? Writer::kStep : 0);
    auto& line = lines.back();
    if (word == "var" || word == "port" || word == "priority") {
      line.shape = Shape::Items;
      line.hang = word.size() + 1;
    }
    if (word == "port") line.kind = LineKind::Ports;
    if (word == "from") separate();
    take();
    if (word == "from") take();
    if (word != "init" && word != "begin" && word != "from") return;
    ended = true;
    frames.push_back({Block::Body, 0});
  }

  // --- Compositions
  void openComposition() {
    const auto indent = compositions * Writer::kStep;
    if (compositions == 0) start(0);
    ++compositions;
    lines.back().kind = LineKind::Head;
    take();
    if (isAtPortSet())
      while (!isAt("in")) take();
    if (isAt("in")) take();
    ended = true;
    nextInstance(indent, "");
  }

  [[nodiscard]] bool isAtPortSet() const {
    std::size_t ahead = 0;
    while (peek(ahead).kind == TokenKind::Name && isAt(",", ahead + 1)) ahead += 2;
    return isAt("in", ahead + 1);
  }

  void nextInstance(std::size_t indent, std::string_view sign) {
    start(indent, sign, 4);
    lines.back().kind = LineKind::Head;
  }

  void composition() {
    const auto indent = (compositions - 1) * Writer::kStep;
    if (isAt("||")) {
      nextInstance(indent, "||");
      ++at;
      return;
    }
    if (!isAt("end")) return take();
    start(indent);
    take();
    if (isAt("par")) take();
    --compositions;
    ended = compositions == 0;
  }

  // --- Statements
  void statement() {
    const Frame frame = frames.back();
    if (isAt("[") && isAt("]", 1) && peek().end() == peek(1).begin && isSeparator())
      return branch(frame);
    if (isAt("|") && frame.block == Block::Case) return pattern(frame, "|");
    const auto word = peek().kind == TokenKind::Name ? peek().text : std::string_view();
    if (word == "unless" || word == "else" || word == "elsif") return otherArm(frame);
    if (word == "end") return close(frame);
    if (ended) start(frame.indent + Writer::kStep);
    const auto indent = lines.back().indent + lines.back().leadWidth;
    if (word == "if" || word == "while" || word == "foreach") {
      if (staysOnOneLine(indent)) return takeBlock();
      open(word == "if" ? Block::If : Block::Loop, indent);
    } else if (word == "select" || word == "case") {
      open(word == "select" ? Block::Select : Block::Case, indent);
      ended = word == "select";
    } else if (word == "of" && frame.block == Block::Case) {
      take();
      ended = true;
      pattern(frame, "");
    } else {
      const bool ends = word == "then" || word == "do" || isAt(";");
      const bool arrow = isAt("->");
      take();
      ended = ends || (arrow && !simpleBeside());
    }
  }

  [[nodiscard]] bool isSeparator() const {
    return previous() && !isAmong(previous()->text, kBeforeExpression);
  }

  /// Whether the word begins a block. The same keyword may follow the block's `end`.
  [[nodiscard]] bool isAtBlock(std::size_t ahead = 0) const {
    constexpr auto kBlocks =
        std::to_array<std::string_view>({"if", "case", "select", "while", "foreach"});
    return isAmong(peek(ahead).text, kBlocks);
  }

  void open(Block block, std::size_t indent) {
    frames.push_back({block, indent});
    take();
  }

  void branch(const Frame& frame) {
    at += 2;
    const bool beside = besidePrevious();
    at -= 2;
    start(frame.indent, "[]", 4);
    at += 2;
    ended = !beside;
    if (!beside) lines.back().leadWidth = 2;
  }

  void pattern(const Frame& frame, std::string_view sign) {
    start(frame.indent, sign, 2);
    if (!sign.empty()) ++at;
  }

  void otherArm(const Frame& frame) {
    const bool complete = !isAt("elsif");
    start(frame.indent);
    take();
    ended = complete;
  }

  void close(const Frame& frame) {
    start(frame.indent);
    take();
    if (isAtBlock()) take();
    frames.pop_back();
  }

  /// Whether a single statement fits on the line of its pattern.
  [[nodiscard]] bool simpleBeside() const {
    if (!besidePrevious()) return false;
    for (std::size_t ahead = 0;; ++ahead) {
      const auto word = peek(ahead).text;
      if (word == "|" || word == "end") return true;
      if (peek(ahead).kind == TokenKind::End || isComment(all[words[at + ahead] + 1])) return false;
      if (isAmong(word, std::to_array<std::string_view>(
                            {";", "if", "select", "case", "while", "foreach"})))
        return false;
    }
  }

  /// Number of tokens up to the `end` of the current block, including a keyword after it.
  [[nodiscard]] std::size_t blockLength() const {
    std::size_t open = 0;
    for (std::size_t ahead = 0; peek(ahead).kind != TokenKind::End; ++ahead) {
      const auto word = peek(ahead).text;
      if (word == "if" || word == "while" || word == "foreach") ++open;
      if (word != "end") continue;
      const bool again = isAtBlock(ahead + 1);
      if (--open == 0) return ahead + (again ? 2 : 1);
      if (again) ++ahead;
    }
    return 0;
  }

  /// Whether the block stays on one line: the user wrote it so, each branch has one statement, and
  /// it fits.
  [[nodiscard]] bool staysOnOneLine(std::size_t indent) const {
    const auto length = blockLength();
    std::vector<Token> tokens;
    for (std::size_t ahead = 0; ahead < length; ++ahead) {
      tokens.push_back(peek(ahead));
      const auto word = peek(ahead).text;
      if (word == ";" || word == "select" || word == "case") return false;
      if (ahead + 1 == length) break;
      if (isComment(all[words[at + ahead] + 1])) return false;
      if (isLineBreak(text, peek(ahead), peek(ahead + 1))) return false;
    }
    constexpr std::size_t kSemicolon = 1;
    const auto width = onOneLine(LineKind::Plain, tokens).size() + kSemicolon;
    return length > 0 && indent + width <= Writer::kWidth;
  }

  void takeBlock() {
    for (auto left = blockLength(); left > 0; --left) take();
  }

  /// The indentation of a comment: that of the line it touches, or of the next one if it touches
  /// both or neither.
  [[nodiscard]] std::size_t commentIndent(std::size_t i) override {
    const Token& next = peek();
    const auto inComposition = compositions * Writer::kStep;
    const auto body = frames.empty() ? inComposition : frames.back().indent + Writer::kStep;
    const bool closes = next.text == "end" || next.text == "else" || next.text == "elsif" ||
                        next.text == "unless" || next.text == "|" || next.text == "[";
    const bool atSection = isAtSection() || isAtDeclaration() || next.kind == TokenKind::End;
    const bool behind = !blankBefore(i) && blankBefore(lastTouching(i) + 1);
    if (atSection || isAtEntry()) return behind ? body : 0;
    if (closes && !frames.empty())
      return column(all[i]) > column(next) ? body : frames.back().indent;
    return body;
  }

  bool head = false;
  bool inFunction = false;
  bool attached = false;        ///< the previous line is `observer > model`
  std::size_t compositions = 0; ///< number of open `par`s
  std::vector<Frame> frames;
};

} // namespace

std::vector<FormatLine> splitLines(std::string_view text, const std::vector<Token>& tokens) {
  return Splitter(text, tokens).run();
}

} // namespace proskill::fiacre
