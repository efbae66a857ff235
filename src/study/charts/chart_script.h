// A gnuplot script as it is written: what the scripts of all charts begin and end with, and commands for texts, lines,
// areas and points at given pixels of the picture, which gnuplot cannot lay out itself. Must not know: what is charted.
#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>

#include "study/charts/label_places.h"

namespace tyg {

class ChartScript {
 public:
  /// Of a picture of so many pixels; `letters`: pixels of the font in the SVG; `digits`: of the edges of panels.
  ChartScript(double width, double height, int letters = 23, int digits = 6)
      : width_(width), height_(height), letters_(letters), digits_(digits) {}

  /// Adds text as it is, or as fmt::format() makes it.
  void add(std::string_view text) { text_ += text; }
  template <class First, class... More>
  void add(fmt::format_string<First, More...> format, First&& first, More&&... more) {
    text_ += fmt::format(format, std::forward<First>(first), std::forward<More>(more)...);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

  /// Names the two pictures that the script draws, where its caller has not: NAME.svg and NAME.png.
  void namePictures(std::string_view name);
  /// Opens a loop over the terminals svg and pngcairo, whose variable is `kind`, with what all charts look like.
  void beginPictures();
  void endPictures();
  /// `set` commands for the border and the tics of a chart.
  static constexpr std::string_view kFrame =
      "  set border 3 lc '#444444' lw 1.5\n  set tics out nomirror textcolor '#222222'\n";

  // All of the following write `set` commands, which the next `plot` draws, between beginPictures() and endPictures().

  /// Where the axes of the next plot are.
  void panel(const PixelBox& edges);

  enum class Side { Left, Centre, Right };
  struct TextStyle {
    std::string colour;
    double scale = 1;  ///< of the font's size
    Side side = Side::Left;
    bool upward = false;  ///< turned, to be read from below
  };
  /// `words` may be anybody's: nothing in them is read by gnuplot.
  void label(const std::string& words, const Pixel& at, const TextStyle& style);
  /// The first line of a chart: `scene`, anybody's title of it, and what is charted. Large letters become smaller where
  /// they do not fit, and `scene` is cut short where that does not help.
  void title(const std::string& scene, const std::string& what, const Pixel& at);
  /// A point of one of gnuplot's types.
  void point(const Pixel& at, int type, double size, const std::string& colour);

  struct LineStyle {
    std::string colour;
    double width = 2;  ///< pixels, about
    int dash = 1;      ///< gnuplot's dash type
    bool head = false, front = false;
  };
  void line(const Pixel& from, const Pixel& to, const LineStyle& style);
  /// A filled rectangle behind everything.
  void area(const PixelBox& box, const std::string& colour);

 private:
  [[nodiscard]] std::string screen(const Pixel& at) const;

  std::string text_;
  double width_, height_;
  int letters_, digits_;
};

}  // namespace tyg
