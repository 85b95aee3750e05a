#include "fiacre/format/format_lines.h"
#include "fiacre/print/writer.h"

#include <algorithm>

namespace proskill::fiacre {
namespace {

/// Replaces white space at which no line may end: in strings and comments.
constexpr char kSpace = '\x01';
constexpr char kNewline = '\x02';

std::string masked(const Token& token) {
  std::string result(token.text);
  if (token.kind != TokenKind::String && token.kind != TokenKind::Comment) return result;
  std::ranges::replace(result, ' ', kSpace);
  std::ranges::replace(result, '\n', kNewline);
  return result;
}

std::string unmasked(std::string text) {
  std::ranges::replace(text, kSpace, ' ');
  std::ranges::replace(text, kNewline, '\n');
  return text;
}

bool endsItsLine(const Token& token) { return isComment(token) && token.text.starts_with("//"); }

/// Counts open parentheses, records and intervals of time.
class Nesting {
public:
  void read(const Token& token) {
    const auto text = token.text;
    const bool bracket = text == "[" || text == "]";
    if (token.kind == TokenKind::Comment || token.kind == TokenKind::String) return;
    if (bracket && (previous == "in" || inInterval)) {
      inInterval = !inInterval;
      inInterval ? ++open : --open;
    } else if (text == "(" || text == "{" || text == "{|" || text == "[" || text == "record") {
      ++open;
    } else if (text == ")" || text == "}" || text == "|}" || text == "]" || text == "end") {
      open -= open > 0 ? 1 : 0;
    }
    previous = text;
  }

  [[nodiscard]] std::size_t depth() const { return open; }

private:
  std::size_t open = 0;
  bool inInterval = false;
  std::string_view previous;
};

/// Part of a line: its tokens with their spaces, and what follows them.
struct Piece {
  std::string text;
  std::string comment;
};

/// The tokens of a line, cut after comments and where the line's shape requires it.
class Pieces {
public:
  Pieces(std::string_view read, const FormatLine& of) : text(read), line(of) {
    commented = std::ranges::any_of(line.tokens, isComment);
  }

  std::vector<Piece> cut() {
    Spacing spacing(line.kind);
    const Token end{};
    pieces.emplace_back();
    for (std::size_t i = 0; i < line.tokens.size(); ++i) {
      const Token& token = line.tokens[i];
      const bool space =
          spacing.before(token, i + 1 < line.tokens.size() ? line.tokens[i + 1] : end);
      if (!pieces.back().text.empty() && cutBefore(i)) pieces.emplace_back();
      const bool isLast = i + 1 == line.tokens.size();
      // a comment at the end of a line stays there, however long: alone on a line it would be a
      // separate item
      if (endsItsLine(token) || (isComment(token) && isLast && !pieces.back().text.empty())) {
        pieces.back().comment = token.text;
        if (!isLast) pieces.emplace_back();
        continue;
      }
      if (space && !pieces.back().text.empty()) pieces.back().text += ' ';
      pieces.back().text += masked(token);
      count(token);
    }
    return std::move(pieces);
  }

  [[nodiscard]] bool hasComments() const { return commented; }

private:
  /// Whether a line must break before a token: a comment on a line of its own, or the next item if
  /// each has its line.
  bool cutBefore(std::size_t i) {
    if (i > 0 && endsItsLine(line.tokens[i]) &&
        isLineBreak(text, line.tokens[i - 1], line.tokens[i]))
      return true;
    if (!commented || line.shape != FormatLine::Shape::Items || isComment(line.tokens[i]))
      return false;
    if (line.tokens[i - 1].text != "," || nesting.depth() > 0 || !typed) return false;
    typed = false;
    return true;
  }

  void count(const Token& token) {
    nesting.read(token);
    if (token.text == ":" && nesting.depth() == 0) typed = true;
  }

  std::string_view text;
  const FormatLine& line;
  bool commented = false;
  std::vector<Piece> pieces;
  Nesting nesting;
  bool typed = false; ///< the type of the current item was written: a comma then follows the whole
                      ///< item
};

class Lines {
public:
  explicit Lines(std::string_view of) : source(of) {}

  void write(const FormatLine& line) {
    if ((line.blank || afterHead) && !out.empty()) out += '\n';
    afterHead = false;
    switch (line.shape) {
    case FormatLine::Shape::Comment:
      out += std::string(line.indent, ' ') + std::string(line.tokens[0].text) + '\n';
      return;
    case FormatLine::Shape::Head:
      if (writeHead(line)) return;
      break;
    case FormatLine::Shape::Type:
      if (writeType(line)) return;
      break;
    case FormatLine::Shape::Statement:
    case FormatLine::Shape::Items: break;
    }
    writePieces(line, line.indent, line.hang);
  }

  std::string take() { return std::move(out); }

private:
  void put(std::size_t indent, const std::string& line, std::string_view comment,
           std::size_t hang) {
    Writer writer;
    std::string laidOut;
    if (!line.empty()) {
      writer.line(indent, line, {}, hang);
      laidOut = unmasked(writer.take());
      laidOut.pop_back();
    } else {
      laidOut.append(indent, ' ');
    }
    if (!comment.empty()) laidOut += (line.empty() ? "" : " ") + std::string(comment);
    out += laidOut + '\n';
  }

  void writePieces(const FormatLine& line, std::size_t indent, std::size_t hang) {
    const auto pieces = Pieces(source, line).cut();
    // the first item's continuation lines are indented normally; the next items are aligned below
    // the first
    const bool items = line.shape == FormatLine::Shape::Items && pieces.size() > 1;
    const auto lead = line.lead + std::string(line.leadWidth - line.lead.size(), ' ');
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const auto& [text, comment] = pieces[i];
      if (i == 0) {
        const auto whole = lead + text;
        const bool bare = text.empty() && !comment.empty(); // `[]  // why`
        put(indent, bare ? line.lead : whole, comment,
            items ? Writer::kStep : hang + line.leadWidth);
      } else {
        put(indent + hang, text, comment, Writer::kStep);
      }
    }
  }

  static bool fits(const FormatLine& line) {
    return line.indent + onOneLine(line.kind, line.tokens).size() <= Writer::kWidth;
  }

  /// Writes the name, the ports and the parameters on a line each.
  bool writeHead(const FormatLine& line) {
    if (fits(line) || std::ranges::any_of(line.tokens, isComment)) return false;
    std::vector<std::vector<Token>> parts(1);
    Nesting nesting;
    for (const Token& token : line.tokens) {
      const bool outside = nesting.depth() == 0;
      nesting.read(token);
      if (outside && nesting.depth() > 0) parts.emplace_back();
      parts.back().push_back(token);
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
      put(i == 0 ? 0 : Writer::kStep, onOneLine(line.kind, parts[i]), {}, 1);
    afterHead = true;
    return true;
  }

  /// Writes `type NAME is record`, the members, and `end`.
  bool writeType(const FormatLine& line) {
    const auto& tokens = line.tokens;
    const bool commented = std::ranges::any_of(tokens, isComment);
    if (fits(line) && !commented) return false;
    const auto opening = std::ranges::find_if(
        tokens, [](const Token& it) { return it.text == "record" || it.text == "union"; });
    const auto closing = std::find_if(tokens.rbegin(), tokens.rend(), [](const Token& it) {
                           return it.text == "end" && it.kind == TokenKind::Name;
                         }).base();
    if (opening == tokens.end() || closing <= opening || opening[-1].text != "is") return false;
    auto members = opening + 1;
    if (endsItsLine(*members)) ++members;
    part(line, {tokens.begin(), members}, 0, Writer::kStep);
    if (commented)
      for (auto from = members; from != closing - 1;) {
        const auto to = memberEnd(from, closing - 1);
        part(line, {from, to}, Writer::kStep, Writer::kStep);
        from = to;
      }
    else
      part(line, {members, closing - 1}, Writer::kStep, 0);
    part(line, {closing - 1, tokens.end()}, 0, Writer::kStep);
    return true;
  }

  using Tokens = std::vector<Token>;

  /// The position after a member's separator and the comment that trails it.
  Tokens::const_iterator memberEnd(Tokens::const_iterator from, Tokens::const_iterator last) const {
    std::size_t depth = 0;
    bool typed = false;
    for (auto at = from; at != last; ++at) {
      if (isComment(*at) && at == from) return at + 1;
      if (at->text == "record" || at->text == "union") ++depth;
      if (at->text == "end" && depth > 0) --depth;
      if (at->text == ":") typed = true;
      const bool separates = depth == 0 && ((at->text == "," && typed) || at->text == "|");
      if (!separates) continue;
      ++at;
      const bool trailed = at != last && isComment(*at) && !isLineBreak(source, at[-1], *at);
      return trailed ? at + 1 : at;
    }
    return last;
  }

  void part(const FormatLine& line, Tokens tokens, std::size_t indent, std::size_t hang) {
    FormatLine piece{
        .kind = line.kind, .indent = indent, .hang = hang, .tokens = std::move(tokens)};
    writePieces(piece, indent, hang);
  }

  std::string_view source;
  std::string out;
  bool afterHead = false;
};

} // namespace

std::string onOneLine(LineKind kind, const std::vector<Token>& tokens) {
  Spacing spacing(kind);
  std::string result;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool space = spacing.before(tokens[i], i + 1 < tokens.size() ? tokens[i + 1] : Token{});
    result += (space ? " " : "") + masked(tokens[i]);
  }
  return result;
}

std::string writeLines(std::string_view text, const std::vector<FormatLine>& lines) {
  Lines output(text);
  for (const auto& line : lines) output.write(line);
  return output.take();
}

} // namespace proskill::fiacre
