// Pixels become fractions of gnuplot's screen, which count from the lower left corner.
#include "study/charts/chart_pen.h"

#include "study/charts/gnuplot.h"

namespace tyg {

void namePictures(std::ostream& out, const std::string& name) {
  for (const char* kind : {"svg", "png"}) {
    out << "if (!exists('" << kind << "')) " << kind << " = '" << name << "." << kind << "'\n";
  }
}

void beginPictures(std::ostream& out, double width, double height, int letters) {
  out << "do for [kind in 'svg png'] {\n"
      << "  if (kind eq 'svg') { set terminal svg size " << width << "," << height
      << " dynamic enhanced background '#ffffff' font 'DejaVu Sans," << letters
      << "' } else { set terminal pngcairo size " << width << "," << height
      << " enhanced background '#ffffff' font 'DejaVu Sans,17' }\n"
      << "  set output kind eq 'svg' ? svg : png\n  set multiplot\n"
      << kChartFrame << "  unset key\n";
}

void endPictures(std::ostream& out) { out << "  unset multiplot\n  unset output\n}\n"; }

std::string ChartPen::screen(const Pixel& at) const {
  std::ostringstream text;
  text << "screen " << at.x / width_ << "," << 1 - at.y / height_;
  return text.str();
}

std::string ChartPen::fontSize(double scale) {
  std::ostringstream text;
  text << "(kind eq 'svg' ? 23 : 17) * " << scale;
  return text.str();
}

void ChartPen::text(const std::string& words, const Pixel& at, const TextLook& look) {
  const char* side = look.side == Side::Left ? "left" : look.side == Side::Right ? "right" : "center";
  out_ << "  set label " << gnuplotQuoted(words) << " at " << screen(at) << (look.upward ? " rotate by 90 " : " ")
       << side << " font sprintf(',%g', " << fontSize(look.scale) << ") textcolor rgb '" << look.colour
       << "' noenhanced front\n";
}

void ChartPen::point(const Pixel& at, int type, double size, const std::string& colour) {
  out_ << "  set label '' at " << screen(at) << " point pt " << type << " ps " << size << " lw 2.5 lc rgb '" << colour
       << "' front\n";
}

void ChartPen::line(const Pixel& from, const Pixel& to, const LineLook& look) {
  out_ << "  set arrow from " << screen(from) << " to " << screen(to)
       << (look.head ? " head filled size screen 0.006,20" : " nohead") << " lw " << look.width << " dt " << look.dash
       << " lc rgb '" << look.colour << "' " << (look.front ? "front" : "back") << "\n";
}

void ChartPen::area(const PixelBox& box, const std::string& colour) {
  out_ << "  set object rectangle from " << screen({box.left, box.bottom}) << " to " << screen({box.right, box.top})
       << " fc rgb '" << colour << "' fs solid noborder behind\n";
}

}  // namespace tyg
