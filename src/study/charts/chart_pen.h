// gnuplot's commands for texts, lines, areas and points at given pixels of a picture, which it cannot lay out itself,
// and what the scripts of all charts begin and end with. Must not know: what is charted.
#pragma once

#include <sstream>
#include <string>

#include "study/charts/label_places.h"

namespace tyg {

/// Names the two pictures that a script draws, where its caller has not: NAME.svg and NAME.png.
void namePictures(std::ostream& out, const std::string& name);
/// Opens a loop over the terminals svg and pngcairo, whose variable is `kind`, in pixels, with what all charts look
/// like; `letters`: pixels of the font in the SVG.
void beginPictures(std::ostream& out, double width, double height, int letters = 23);
void endPictures(std::ostream& out);
/// `set` commands for the border and the tics of a chart.
inline constexpr const char* kChartFrame =
    "  set border 3 lc '#444444' lw 1.5\n  set tics out nomirror textcolor '#222222'\n";

/// Writes `set` commands that the next `plot` draws. They stand between beginPictures() and
/// endPictures().
class ChartPen {
 public:
  ChartPen(std::ostream& out, double width, double height) : out_(out), width_(width), height_(height) {}

  enum class Side { Left, Centre, Right };
  struct TextLook {
    std::string colour;
    double scale = 1;  ///< of the font's size
    Side side = Side::Left;
    bool upward = false;  ///< turned, to be read from below
  };
  void text(const std::string& words, const Pixel& at, const TextLook& look);
  /// A point of one of gnuplot's types.
  void point(const Pixel& at, int type, double size, const std::string& colour);

  struct LineLook {
    std::string colour;
    double width = 2;  ///< pixels, about
    int dash = 1;      ///< gnuplot's dash type
    bool head = false, front = false;
  };
  void line(const Pixel& from, const Pixel& to, const LineLook& look);
  /// A filled rectangle behind everything.
  void area(const PixelBox& box, const std::string& colour);

  /// A gnuplot expression for the size of the font.
  static std::string fontSize(double scale);

 private:
  [[nodiscard]] std::string screen(const Pixel& at) const;

  std::ostream& out_;
  double width_, height_;
};

}  // namespace tyg
