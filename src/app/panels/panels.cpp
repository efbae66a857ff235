// Opening, closing and placing panels; see panels.h.
#include "app/panels/panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace tyg {
namespace {

/// Of the window's width, at most, for a panel that stands at an edge: the cloth keeps the middle.
constexpr float kWidestShare = 0.46F;
constexpr float kNarrowest = 8;  ///< text sizes, in whatever window: ImGui takes no widget without a size
/// From the window's edges, in text sizes: the title is above.
constexpr float kSide = 0.6F, kAbove = 2.4F, kBetween = 0.5F;
constexpr float kLowest = 6;  ///< a panel is at least this high before it gets a scroll bar, in text sizes

std::size_t placeOf(InputAction action) {
  const auto table = panelTable();
  return static_cast<std::size_t>(std::ranges::find(table, action, &PanelKind::action) - table.begin());
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
}

float Panels::widthOf(const PanelKind& kind) const {
  const float share = std::max(kWidestShare * ImGui::GetIO().DisplaySize.x, kNarrowest * size_);
  return std::round(std::min(kind.width * size_, share));
}

float Panels::width(Edge edge) const {
  float widest = 0;
  for (const std::size_t which : order_) {
    const PanelKind& kind = panelTable()[which];
    if (kind.edge == edge && !places_[which].dragged) widest = std::max(widest, widthOf(kind) + 2 * kSide * size_);
  }
  return widest;
}

bool Panels::busy() const {
  return std::ranges::any_of(order_, [this](std::size_t which) { return places_[which].panel->busy(); });
}

void Panels::draw(Viewer& viewer) {
  applyStyle(viewer.drawOptions().background, size_);
  std::array<float, 2> top{kAbove * size_, kAbove * size_};
  for (std::size_t which = 0; which < places_.size(); ++which) {
    Place& place = places_[which];
    if (!place.open) continue;
    float& y = top.at(static_cast<std::size_t>(panelTable()[which].edge));
    drawOne(which, viewer, y);
    if (place.open && !place.dragged) y += place.height + kBetween * size_;
  }
}

void Panels::drawOne(std::size_t which, Viewer& viewer, float top) {
  const PanelKind& kind = panelTable()[which];
  Place& place = places_[which];
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float lowest = kLowest * size_, width = widthOf(kind);
  const float bottom = std::min(floor_, screen.y);
  // Where the edge is full, a panel lies over the others rather than below the window.
  const float y = std::max(std::min(top, bottom - std::max(place.height, lowest)), std::min(kAbove * size_, top));
  const float room = std::max(bottom - y, lowest);
  const float x = std::round(kind.edge == Edge::Left ? kSide * size_ : screen.x - width - kSide * size_);
  // Only where its place has changed: ImGui moves a window that is being dragged before this.
  if (!place.dragged && (x != place.x || std::round(y) != place.y)) {
    place.x = x, place.y = std::round(y);
    ImGui::SetNextWindowPos({place.x, place.y});
  }
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, room});
  if (kind.height > 0) ImGui::SetNextWindowSize({width, std::min(kind.height * size_, room)});
  bool open = true;
  const int flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                    ImGuiWindowFlags_NoNav | (kind.height > 0 ? 0 : ImGuiWindowFlags_AlwaysAutoResize);
  const std::string title(kind.title);
  ImGui::Begin(title.c_str(), &open, flags);
  const Background background = viewer.drawOptions().background;
  place.panel->draw({viewer, edits_, coloursOn(background), background, size_});
  const ImVec2 at = ImGui::GetWindowPos();
  place.shownX = at.x, place.shownY = at.y;
  place.width = ImGui::GetWindowWidth(), place.height = ImGui::GetWindowHeight();
  // ImGui itself moves a panel that would stand outside of a small window.
  const bool byHand = ImGui::IsWindowFocused() && ImGui::IsMouseDragging(ImGuiMouseButton_Left);
  ImGui::End();
  if (byHand && (std::abs(at.x - place.x) > 1 || std::abs(at.y - place.y) > 1)) place.dragged = true;
  if (!open) setOpen(which, false);
}

}  // namespace tyg
