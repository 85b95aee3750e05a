#include "viz/dot/text_width.h"

#include "syntax/text/utf8.h"

#include <array>

namespace proskill::viz {
namespace {

using Widths = std::array<std::uint16_t, 127 - ' '>;

// clang-format off
/// Widths of the characters from space to tilde in DejaVu Sans, in thousandths of the font size.
constexpr Widths kPlain{
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635, 611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838,
};
constexpr Widths kBold{
    348, 456, 521, 838, 696, 1002, 872, 306, 457, 457, 523, 838, 380, 415, 380, 365, 696, 696, 696,
    696, 696, 696, 696, 696, 696, 696, 400, 400, 838, 838, 838, 580, 1000, 774, 762, 734, 830, 683,
    683, 821, 837, 372, 372, 775, 637, 995, 837, 850, 733, 850, 770, 720, 682, 812, 774, 1103, 771,
    724, 725, 457, 365, 457, 838, 500, 500, 675, 716, 593, 716, 678, 435, 716, 712, 343, 343, 665,
    343, 1042, 712, 687, 716, 716, 493, 595, 478, 712, 652, 924, 645, 652, 582, 712, 365, 712, 838,
};
// clang-format on

/// Other characters have the width of most letters. From this code point on, East Asian characters
/// and pictographs have twice that.
constexpr char32_t kFirstWide = 0x1100;
constexpr int kOther = 640;
constexpr int kOtherBold = 700;

int widthOf(char32_t character, bool bold) {
  const auto& widths = bold ? kBold : kPlain;
  if (character >= U' ' && character - U' ' < widths.size()) return widths[character - U' '];
  const auto other = bold ? kOtherBold : kOther;
  const bool wide = character >= kFirstWide && (character < 0x2000 || character >= 0x2E80);
  if (character == U'…') return 1000;
  return wide ? 2 * other : other;
}

} // namespace

double textWidth(std::string_view text, bool bold) {
  int sum = 0;
  syntax::forEachCharacter(text, [&](char32_t character, std::string_view /*bytes*/) {
    sum += widthOf(character, bold);
  });
  return sum / 1000.0;
}

} // namespace proskill::viz
