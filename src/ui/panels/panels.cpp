// Opening, closing and placing panels; see panels.h.
#include "ui/panels/panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace tyg {
namespace {

/// Of the window's width, at most, for a panel that stands at an edge: the cloth keeps the middle.
constexpr float kWidestShare = 0.46F;
constexpr float kNarrowest = 8;  ///< text sizes, in whatever window: ImGui takes no widget without a size
/// From the window's edges, in text sizes: the title is above.
constexpr float kSide = 0.6F, kAbove = 2.4F, kBetween = 0.25F;
/// For a folded panel to unfold by itself, in text sizes: else one with a line that comes and goes would flutter.
constexpr float kLeeway = 2;
constexpr double kTipFrom = 0.25, kTipUntil = 4;  ///< s of the mouse's rest, in which tooltips show
constexpr float kLowest = 6;  ///< a panel is at least this high before it gets a scroll bar, in text sizes

std::size_t placeOf(InputAction action) {
  const auto table = panelTable();
  return static_cast<std::size_t>(std::ranges::find(table, action, &PanelKind::action) - table.begin());
}

/// A click that ends now and was no drag that came from somewhere else.
bool clicked() {
  const ImVec2 way = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left);
  return ImGui::IsMouseReleased(ImGuiMouseButton_Left) && way.x == 0 && way.y == 0;
}

}  // namespace

bool Panels::covers(double x, double y) const {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  x /= std::max(scale.x, 0.01F), y /= std::max(scale.y, 0.01F);
  return std::ranges::any_of(order_, [&](std::size_t which) {
    const Place& place = places_[which];
    return x >= place.shownX && x < place.shownX + place.width && y >= place.shownY && y < place.shownY + place.height;
  });
}

/// ImGui's own word for it comes a frame late: a quick hand has moved to a panel, or away from it, since.
bool Panels::takesMouse(const WindowEvent& event) const {
  constexpr int kAny = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
  return covers(event.x, event.y) || ImGui::IsPopupOpen("", kAny) || ImGui::IsAnyItemActive();
}

bool Panels::handle(const WindowEvent& event, Viewer& viewer) {
  if (event.kind != WindowEvent::Kind::Press) return false;
  if (isMouse(event.key)) {
    const auto takes = [&](std::size_t which) { return places_[which].panel->handle(event, viewer); };
    return takesMouse(event) || std::ranges::any_of(order_, takes);
  }
  if (event.control) {
    handleControl(event, viewer);
    return true;
  }
  if (event.key == kEscapeKey && !order_.empty()) {
    closeLast();
    return true;
  }
  const Input* input = findInput(event.key);
  if (input == nullptr || placeOf(input->action) == places_.size()) return false;
  toggle(input->action);
  return true;
}

void Panels::handleControl(const WindowEvent& event, Viewer& viewer) {
  const bool redo = event.key == 'Y' || (event.key == 'Z' && event.shift);
  if (redo) {
    edits_.redo(viewer);
  } else if (event.key == 'Z') {
    edits_.undo(viewer);
  }
}

void Panels::toggle(InputAction action) {
  const std::size_t which = placeOf(action);
  if (which < places_.size()) setOpen(which, !places_[which].open);
}

bool Panels::isOpen(InputAction action) const {
  const std::size_t which = placeOf(action);
  return which < places_.size() && places_[which].open;
}

void Panels::setOpen(std::size_t which, bool open) {
  Place& place = places_[which];
  if (place.open == open) return;
  if (!place.panel) place.panel = panelTable()[which].make();
  place.open = open;
  std::erase(order_, which);
  if (open) {
    order_.push_back(which);
  } else {
    place.panel->close();
  }
}

void Panels::closeLast() { setOpen(order_.back(), false); }

void Panels::follow(Viewer& viewer) {
  for (const std::size_t which : order_) places_[which].panel->follow(viewer);
  if (!ImGui::IsAnyItemActive()) edits_.follow(viewer);
}

void Panels::paint(ClothPicture& picture) {
  for (const std::size_t which : order_) places_[which].panel->paint(picture);
  colouredBy_ = picture.options.colouring.by;
}

/// A panel that gets less than the width it was made for is drawn smaller as a whole, so that nothing in it is cut.
float Panels::textSize(const PanelKind& kind) const {
  const float share = std::max(kWidestShare * ImGui::GetIO().DisplaySize.x, kNarrowest * size_);
  return std::min(size_, share / kind.width);
}

float Panels::widthOf(const PanelKind& kind) const { return std::round(kind.width * textSize(kind)); }

bool Panels::stands(std::size_t which, Edge edge) const {
  return places_[which].open && !places_[which].dragged && panelTable()[which].edge == edge;
}

float Panels::width(Edge edge) const {
  float widest = 0;
  for (const std::size_t which : order_) {
    const PanelKind& kind = panelTable()[which];
    if (kind.edge == edge && !places_[which].dragged) widest = std::max(widest, widthOf(kind) + 2 * kSide * size_);
  }
  return widest;
}

float Panels::beside() const {
  float farthest = 0;
  for (const std::size_t which : order_) farthest = std::max(farthest, places_[which].panel->beside());
  return farthest;
}

bool Panels::busy() const {
  // A tooltip comes and goes by itself.
  if (ImGui::GetIO().WantCaptureMouse && ImGui::GetTime() < rested_ + kTipUntil + 0.1) return true;
  return std::ranges::any_of(order_, [this](std::size_t which) { return places_[which].panel->busy(); });
}

void Panels::draw(Viewer& viewer) {
  watchMouse();
  arrange(Edge::Left), arrange(Edge::Right);
  for (std::size_t which = 0; which < places_.size(); ++which) {
    if (places_[which].open) drawOne(which, viewer);
  }
}

void Panels::watchMouse() {
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  if (moved.x != 0 || moved.y != 0) rested_ = ImGui::GetTime();
  if (ImGui::IsAnyItemActive()) rested_ = -1e6;  // until it moves again
}

/// The newest is whole; the others are as far as the height goes, the newer ones first.
void Panels::arrange(Edge edge) {
  const float top = kAbove * size_, between = kBetween * size_;
  const float height = std::min(floor_, ImGui::GetIO().DisplaySize.y) - top;
  float spare = height + between;
  for (const std::size_t which : order_) {
    if (stands(which, edge)) spare -= places_[which].title + between;
  }
  bool newest = true;
  for (std::size_t k = order_.size(); k-- > 0;) {
    Place& place = places_[order_[k]];
    if (!stands(order_[k], edge)) continue;
    const float more = std::max(0.0F, place.natural - place.title);
    place.folded = !newest && more + (place.folded ? kLeeway * size_ : 0) > spare;
    if (!place.folded) spare -= more;
    newest = false;
  }
  float y = top;
  for (std::size_t which = 0; which < places_.size(); ++which) {
    Place& place = places_[which];
    if (place.dragged) place.folded = false, place.room = height;
    if (!stands(which, edge)) continue;
    place.top = y;
    place.room = std::max(std::max(place.natural, place.title) + spare, kLowest * size_);
    y += (place.folded ? place.title : std::min(std::max(place.natural, place.title), place.room)) + between;
  }
}

/// Where ImGui is to put the panel that begins next, and how large it may be.
void Panels::placeNext(std::size_t which) {
  const PanelKind& kind = panelTable()[which];
  Place& place = places_[which];
  const float width = widthOf(kind), side = kSide * size_;
  const float x = std::round(kind.edge == Edge::Left ? side : ImGui::GetIO().DisplaySize.x - width - side);
  // Only where its place has changed: ImGui moves a window that is being dragged before this.
  if (!place.dragged && (x != place.x || std::round(place.top) != place.y)) {
    place.x = x, place.y = std::round(place.top);
    ImGui::SetNextWindowPos({place.x, place.y});
  }
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, place.room});
  if (kind.height > 0) ImGui::SetNextWindowSize({width, std::min(kind.height * textSize(kind), place.room)});
  if (place.folded) ImGui::SetNextWindowCollapsed(true);
}

/// The panel that has just been drawn.
void Panels::measure(std::size_t which) {
  const PanelKind& kind = panelTable()[which];
  Place& place = places_[which];
  const ImVec2 at = ImGui::GetWindowPos();
  place.shownX = at.x, place.shownY = at.y;
  place.width = ImGui::GetWindowWidth(), place.height = ImGui::GetWindowHeight();
  place.title = ImGui::GetFrameHeight();
  if (place.folded) return;
  place.natural = kind.height > 0 ? kind.height * textSize(kind) : place.height + ImGui::GetScrollMaxY();
}

void Panels::drawOne(std::size_t which, Viewer& viewer) {
  const PanelKind& kind = panelTable()[which];
  Place& place = places_[which];
  const Background background = viewer.drawOptions().background;
  const float size = textSize(kind);
  const double rest = ImGui::GetTime() - rested_;
  const bool tips = rest > kTipFrom && rest < kTipUntil;
  applyStyle(background, size);
  placeNext(which);
  bool open = true;
  // Tab goes through the fields while something is typed; else it is the key of a panel.
  const int flags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                    (place.folded ? 0 : ImGuiWindowFlags_NoCollapse) |
                    (ImGui::GetIO().WantTextInput ? 0 : ImGuiWindowFlags_NoNav) |
                    (kind.height > 0 ? 0 : ImGuiWindowFlags_AlwaysAutoResize);
  const std::string title(kind.title);
  ImGui::Begin(title.c_str(), &open, flags);
  const bool onTitle = ImGui::IsItemHovered();
  ImGui::SetWindowFontScale(size / size_);
  if (!place.folded) place.panel->draw({viewer, edits_, coloursOn(background), background, size, tips, colouredBy_});
  if (place.folded && onTitle && tips) ImGui::SetTooltip("a click unfolds it");
  measure(which);
  // ImGui itself moves a panel that would stand outside of a small window.
  const bool byHand = ImGui::IsWindowFocused() && ImGui::IsMouseDragging(ImGuiMouseButton_Left);
  ImGui::End();
  if (byHand && std::max(std::abs(place.shownX - place.x), std::abs(place.shownY - place.y)) > 1) place.dragged = true;
  if (!open) return setOpen(which, false);
  if (place.folded && onTitle && clicked()) std::erase(order_, which), order_.push_back(which);
}

}  // namespace tyg
