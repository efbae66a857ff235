// Pixels become fractions of gnuplot's screen, which count from the lower left corner.
#include "study/charts/chart_script.h"

#include <algorithm>

#include "study/charts/gnuplot.h"
#include "util/utf8.h"
#include "util/visible_text.h"

namespace tyg {

namespace {

/// What a label shows: one line in which nothing is active. gnuplot leaves a mark in SVG that XML forbids in texts.
std::string shownText(const std::string& words) {
  constexpr std::string_view kForbidden = "]]>";
  std::string shown = oneLine(words);
  for (std::size_t at = 0; (at = shown.find(kForbidden, at)) != std::string::npos;) shown.insert(at + 2, " ");
  return shown;
}

}  // namespace

void ChartScript::namePictures(std::string_view name) {
  for (const char* kind : {"svg", "png"}) add("if (!exists('{0}')) {0} = '{1}.{0}'\n", kind, name);
}

void ChartScript::beginPictures() {
  add("set encoding utf8\ndo for [kind in 'svg png'] {\n");
  add("  if (kind eq 'svg') {{ set terminal svg size {0:.9g},{1:.9g} dynamic enhanced background '#ffffff' "
      "font 'DejaVu Sans,{2}' }} else {{ set terminal pngcairo size {0:.9g},{1:.9g} enhanced background '#ffffff' "
      "font 'DejaVu Sans,17' }}\n",
      width_, height_, letters_);
  add("  set output kind eq 'svg' ? svg : png\n  set multiplot\n");
  add(kFrame);
  add("  unset key\n");
}

void ChartScript::endPictures() { add("  unset multiplot\n  unset output\n}\n"); }

void ChartScript::panel(const PixelBox& edges) {
  const auto margin = [&](char side, double fraction) {
    add("  set {}margin at screen {:.{}g}\n", side, fraction, digits_);
  };
  margin('l', edges.left / width_);
  margin('r', edges.right / width_);
  margin('t', 1 - edges.top / height_);
  margin('b', 1 - edges.bottom / height_);
}

std::string ChartScript::screen(const Pixel& at) const {
  return fmt::format("screen {:g},{:g}", at.x / width_, 1 - at.y / height_);
}

void ChartScript::label(const std::string& words, const Pixel& at, const TextStyle& style) {
  const char* side = style.side == Side::Left ? "left" : style.side == Side::Right ? "right" : "center";
  add("  set label {} at {}{} {} font sprintf(',%g', (kind eq 'svg' ? {} : 17) * {:g}) textcolor rgb '{}' noenhanced "
      "front\n",
      gnuplotQuoted(shownText(words)), screen(at), style.upward ? " rotate by 90" : "", side, letters_, style.scale,
      style.colour);
}

void ChartScript::title(const std::string& scene, const std::string& what, const Pixel& at) {
  constexpr double kLargest = 1.4, kRight = 40, kLetterWidth = 12;  // pixels
  const auto fitting = static_cast<std::size_t>((width_ - at.x - kRight) / kLetterWidth);
  std::string words = scene + ": " + what;
  if (characterCount(words) > fitting) {
    const std::string end = "\u2026: " + what;
    words = std::string(cutToBytes(scene, fitting - std::min(fitting, characterCount(end)))) + end;
  }
  const double scale = std::clamp(double(fitting) / double(characterCount(words)), 1.0, kLargest);
  label(words, at, {.colour = "#000000", .scale = scale});
}

void ChartScript::point(const Pixel& at, int type, double size, const std::string& colour) {
  add("  set label '' at {} point pt {} ps {:g} lw 2.5 lc rgb '{}' front\n", screen(at), type, size, colour);
}

void ChartScript::line(const Pixel& from, const Pixel& to, const LineStyle& style) {
  add("  set arrow from {} to {}{} lw {:g} dt {} lc rgb '{}' {}\n", screen(from), screen(to),
      style.head ? " head filled size screen 0.006,20" : " nohead", style.width, style.dash, style.colour,
      style.front ? "front" : "back");
}

void ChartScript::area(const PixelBox& box, const std::string& colour) {
  add("  set object rectangle from {} to {} fc rgb '{}' fs solid noborder behind\n", screen({box.left, box.bottom}),
      screen({box.right, box.top}), colour);
}

}  // namespace tyg
