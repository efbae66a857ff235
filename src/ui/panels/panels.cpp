// Opens, closes and places panels. A panel at an edge of the window has a slot of its own there, in the order of the
// table.
#include "ui/panels/panels.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/core.h>

namespace tyg {
namespace {

/// Of the window's width, at most, for a panel at an edge: the cloth keeps the middle.
constexpr float kWidestShare = 0.46F;
/// Of the window's width, at least, that the cloth keeps between panels at both edges.
constexpr float kLeastBetween = 0.2F;
/// Lines of text that a window has room for at least: in a low one large text is smaller.
constexpr float kFewestLines = 20;
constexpr float kNarrowest = 8;  ///< text sizes, in whatever window: ImGui takes no widget without a size
/// From the window's edges, in text sizes: the title is above.
constexpr float kSide = 0.6F, kAbove = 2.4F, kBetween = 0.25F;
/// For a folded panel to unfold by itself, in text sizes: else one with a line that comes and goes would flutter.
constexpr float kLeeway = 2;
constexpr double kTipFrom = 0.25, kTipUntil = 4;  ///< s of the mouse's rest, in which tooltips show
constexpr float kLowest = 6;  ///< a panel is at least this high before it gets a scroll bar, in text sizes

std::size_t slotOf(InputAction action) {
  const auto table = panelTable();
  return static_cast<std::size_t>(std::ranges::find(table, action, &PanelKind::action) - table.begin());
}

/// A click that ends now and was no drag that came from somewhere else.
bool clicked() {
  const ImVec2 way = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left);
  return ImGui::IsMouseReleased(ImGuiMouseButton_Left) && way.x == 0 && way.y == 0;
}

/// What the foot of the window says.
std::string footText(const Viewer& viewer) {
  StepText step;
  MarginText margin;
  viewer.scenes().describeStep(step);
  describe(viewer.run().margin(), margin);
  std::string text = fmt::format("{}, {}, t = {:.6g} s\n{}\n", viewer.scenes().method().name, step.data(),
                                 viewer.run().shown().time(), margin.data());
  const std::string& failure = viewer.run().failure().message();
  return failure.empty() ? text : text + failure + "\n";
}

/// What ImGui has written since ImGui::LogToBuffer(). The end of any window, also of a tooltip, ends that.
std::string takeWritten() {
  const std::string text = ImGui::GetCurrentContext()->LogBuffer.c_str();
  ImGui::LogFinish();
  return text + "\n";
}

}  // namespace

bool Panels::covers(double x, double y) const {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  x /= std::max(scale.x, 0.01F), y /= std::max(scale.y, 0.01F);
  return std::ranges::any_of(order_, [&](std::size_t which) {
    const Slot& slot = slots_[which];
    return x >= slot.shownX && x < slot.shownX + slot.width && y >= slot.shownY && y < slot.shownY + slot.height;
  });
}

bool Panels::isPopupOpen() {
  return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

/// ImGui's own word for it comes a frame late: a quick hand has moved to a panel, or away from it, since.
bool Panels::takesMouse(const WindowEvent& event) const {
  return covers(event.x, event.y) || isPopupOpen() || ImGui::IsAnyItemActive();
}

bool Panels::handle(const WindowEvent& event, Viewer& viewer) {
  if (event.kind != WindowEvent::Kind::Press) return false;
  if (isMouse(event.key)) {
    const auto takes = [&](std::size_t which) { return slots_[which].panel->handle(event, viewer); };
    return takesMouse(event) || std::ranges::any_of(order_, takes);
  }
  if (event.control) {
    handleControl(event, viewer);
    return true;
  }
  if (event.key == kEscapeKey && !order_.empty()) {
    if (!isPopupOpen()) closeLast();  // else it closes that
    return true;
  }
  const Input* input = findInput(event.key);
  if (input == nullptr) return false;
  if (input->action == InputAction::Undo) return edits_.undo(viewer), true;
  if (input->action == InputAction::Redo) return edits_.redo(viewer), true;
  if (input->action == InputAction::Copy) return copyAsked_ = true;
  if (slotOf(input->action) == slots_.size()) return false;
  toggle(input->action);
  return true;
}

void Panels::handleControl(const WindowEvent& event, Viewer& viewer) {
  const bool redo = event.key == 'Y' || (event.key == 'Z' && event.shift);
  if (redo) {
    edits_.redo(viewer);
  } else if (event.key == 'Z') {
    edits_.undo(viewer);
  } else if (event.key == 'C') {
    copyAsked_ = true;
  }
}

void Panels::toggle(InputAction action) {
  const std::size_t which = slotOf(action);
  if (which < slots_.size()) setOpen(which, !slots_[which].open);
}

bool Panels::isOpen(InputAction action) const {
  const std::size_t which = slotOf(action);
  return which < slots_.size() && slots_[which].open;
}

void Panels::setOpen(std::size_t which, bool open) {
  Slot& slot = slots_[which];
  if (slot.open == open) return;
  if (!slot.panel) slot.panel = panelTable()[which].make();
  slot.open = open;
  std::erase(order_, which);
  if (open) {
    ++timesOpened_;
    order_.push_back(which);
  } else {
    slot.panel->close();
  }
}

/// Whole, and as the one opened last.
void Panels::show(std::size_t which) {
  setOpen(which, true);
  ++timesOpened_;
  std::erase(order_, which);
  order_.push_back(which);
}

void Panels::closeLast() { setOpen(order_.back(), false); }

void Panels::follow(Viewer& viewer) {
  if (const std::optional<InputAction> wanted = viewer.takeWantedPanel()) show(slotOf(*wanted));
  for (const std::size_t which : order_) slots_[which].panel->follow(viewer);
  if (!ImGui::IsAnyItemActive()) edits_.follow(viewer);
}

void Panels::paint(ClothPicture& picture) {
  for (const std::size_t which : order_) slots_[which].panel->paint(picture);
  colouredBy_ = picture.options.colouring.by;
}

float Panels::largestText() const {
  return std::min(size_, std::max(1.0F, ImGui::GetIO().DisplaySize.y / kFewestLines));
}

/// A panel that gets less than the width it was made for is drawn smaller as a whole, so that nothing in it is cut.
float Panels::textSize(const PanelKind& kind) const {
  const float share = std::max(kWidestShare * ImGui::GetIO().DisplaySize.x, kNarrowest * largestText());
  return std::min(largestText(), share / kind.width);
}

float Panels::widthOf(const PanelKind& kind) const { return std::round(kind.width * textSize(kind)); }

/// Folded ones are as wide as those below and above them.
float Panels::widthOf(std::size_t which) const {
  const PanelKind& kind = panelTable()[which];
  if (!slots_[which].folded) return widthOf(kind);
  float widest = 0;
  for (const std::size_t other : order_) {
    if (isAtEdge(other, kind.edge) && !slots_[other].folded) widest = std::max(widest, widthOf(panelTable()[other]));
  }
  return widest > 0 ? widest : widthOf(kind);
}

bool Panels::isAtEdge(std::size_t which, Edge edge) const {
  return slots_[which].open && !slots_[which].dragged && panelTable()[which].edge == edge;
}

bool Panels::isAt(Edge edge) const {
  return std::ranges::any_of(order_, [&](std::size_t which) { return isAtEdge(which, edge); });
}

float Panels::widest(Edge edge) const {
  float widest = 0;
  for (const std::size_t which : order_) {
    if (isAtEdge(which, edge)) widest = std::max(widest, widthOf(panelTable()[which]) + 2 * kSide * largestText());
  }
  return widest;
}

/// To the panels at the other edge, where there is no room for both.
bool Panels::yields(Edge edge) const {
  const auto newest =
      std::find_if(order_.rbegin(), order_.rend(), [&](std::size_t which) { return !slots_[which].dragged; });
  if (newest == order_.rend() || isAtEdge(*newest, edge)) return false;
  return widest(Edge::Left) + widest(Edge::Right) > (1 - kLeastBetween) * ImGui::GetIO().DisplaySize.x;
}

float Panels::width(Edge edge) const { return yields(edge) ? 0 : widest(edge); }

float Panels::titles() const {
  float highest = 0;
  for (const Edge edge : {Edge::Left, Edge::Right}) {
    float high = 0;
    for (const std::size_t which : order_) {
      if (yields(edge) && isAtEdge(which, edge)) high += slots_[which].title + kBetween * largestText();
    }
    highest = std::max(highest, high);
  }
  return highest;
}

float Panels::beside() const {
  float farthest = 0;
  for (const std::size_t which : order_) farthest = std::max(farthest, slots_[which].panel->beside());
  return farthest;
}

bool Panels::busy() const {
  // A tooltip comes and goes by itself.
  if (ImGui::GetIO().WantCaptureMouse && ImGui::GetTime() < rested_ + kTipUntil + 0.1) return true;
  return std::ranges::any_of(order_, [this](std::size_t which) { return slots_[which].panel->busy(); });
}

void Panels::draw(Viewer& viewer) {
  watchMouse();
  arrange(Edge::Left), arrange(Edge::Right);
  std::string copy;
  const bool copies = copyAsked_ && !isPopupOpen();
  if (copies) {
    copyAsked_ = false;
    copy = footText(viewer);
    ImGui::GetCurrentContext()->HoveredWindow = nullptr;  // no tooltips in this frame: they would end the copy
  }
  for (std::size_t which = 0; which < slots_.size(); ++which) {
    if (slots_[which].open) drawOne(which, viewer, copies ? &copy : nullptr);
  }
  if (!copies) return;
  ImGui::SetClipboardText(copy.c_str());
  const bool leavesTheWindow = ImGui::GetIO().ClipboardUserData != nullptr;  // freeglut has no clipboard
  viewer.notes().say(leavesTheWindow ? "The numbers at the lower edge and in the open panels are copied."
                                     : "Copied, but only for fields of this window: freeglut has no clipboard.");
}

void Panels::watchMouse() {
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  if (moved.x != 0 || moved.y != 0) rested_ = ImGui::GetTime();
  if (ImGui::IsAnyItemActive()) rested_ = -1e6;  // until it moves again
}

/// The newest is whole; the others are as far as the height goes, the newer ones first.
void Panels::arrange(Edge edge) {
  const float top = kAbove * largestText(), between = kBetween * largestText();
  const float height = std::min(floor_, ImGui::GetIO().DisplaySize.y) - top;
  const auto lowest = [this](std::size_t which) { return kLowest * textSize(panelTable()[which]); };
  float spare = height + between;
  for (const std::size_t which : order_) {
    if (isAtEdge(which, edge)) spare -= slots_[which].title + between;
  }
  const bool yield = yields(edge);
  bool newest = true;
  for (std::size_t k = order_.size(); k-- > 0;) {
    Slot& slot = slots_[order_[k]];
    if (!isAtEdge(order_[k], edge)) continue;
    const float more = std::max(0.0F, slot.natural - slot.title);
    const bool room = more + (slot.folded ? kLeeway * largestText() : 0) <= spare;
    slot.folded = yield || (!room && (!newest || slot.title + spare < lowest(order_[k])));
    if (!slot.folded) spare -= more;
    newest = false;
  }
  float y = top;
  for (std::size_t which = 0; which < slots_.size(); ++which) {
    Slot& slot = slots_[which];
    if (slot.dragged) slot.folded = false, slot.maxHeight = height;
    if (!isAtEdge(which, edge)) continue;
    slot.top = y;
    slot.maxHeight = std::max(std::max(slot.natural, slot.title) + spare, lowest(which));
    y += (slot.folded ? slot.title : std::min(std::max(slot.natural, slot.title), slot.maxHeight)) + between;
  }
}

/// Where ImGui is to put the panel that begins next, and how large it may be.
void Panels::placeNext(std::size_t which) {
  const PanelKind& kind = panelTable()[which];
  Slot& slot = slots_[which];
  const float width = widthOf(which), side = kSide * largestText();
  const float x = std::round(kind.edge == Edge::Left ? side : ImGui::GetIO().DisplaySize.x - width - side);
  // Only where its position has changed: ImGui moves a window that is being dragged before this.
  if (!slot.dragged && (x != slot.x || std::round(slot.top) != slot.y)) {
    slot.x = x, slot.y = std::round(slot.top);
    ImGui::SetNextWindowPos({slot.x, slot.y});
  }
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, slot.maxHeight});
  if (kind.height > 0) ImGui::SetNextWindowSize({width, std::min(kind.height * textSize(kind), slot.maxHeight)});
  if (slot.folded) ImGui::SetNextWindowCollapsed(true);
}

/// The panel that has just been drawn.
void Panels::measure(std::size_t which) {
  const PanelKind& kind = panelTable()[which];
  Slot& slot = slots_[which];
  const ImVec2 at = ImGui::GetWindowPos();
  slot.shownX = at.x, slot.shownY = at.y;
  slot.width = ImGui::GetWindowWidth(), slot.height = ImGui::GetWindowHeight();
  slot.title = ImGui::GetFrameHeight();
  if (slot.folded) return;
  slot.natural = kind.height > 0 ? kind.height * textSize(kind) : slot.height + ImGui::GetScrollMaxY();
}

/// `copy`: where to add what the panel writes; null: nowhere.
void Panels::drawOne(std::size_t which, Viewer& viewer, std::string* copy) {
  const PanelKind& kind = panelTable()[which];
  Slot& slot = slots_[which];
  const Background background = viewer.view().drawOptions().background;
  const float size = textSize(kind);
  const double rest = ImGui::GetTime() - rested_;
  const bool tips = rest > kTipFrom && rest < kTipUntil;
  applyStyle(background, size);
  placeNext(which);
  bool open = true;
  // Tab goes through the fields while something is typed; else it is the key of a panel.
  const int flags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                    (slot.folded ? 0 : ImGuiWindowFlags_NoCollapse) |
                    (ImGui::GetIO().WantTextInput ? 0 : ImGuiWindowFlags_NoNav) |
                    (kind.height > 0 ? 0 : ImGuiWindowFlags_AlwaysAutoResize);
  const std::string title(kind.title);
  if (copy != nullptr) ImGui::LogToBuffer();
  ImGui::Begin(title.c_str(), &open, flags);
  const bool onTitle = ImGui::IsItemHovered();
  ImGui::SetWindowFontScale(size / size_);
  if (!slot.folded) slot.panel->draw({viewer, edits_, coloursOn(background), background, size, tips, colouredBy_});
  if (slot.folded && onTitle && tips) ImGui::SetTooltip("a click unfolds it");
  measure(which);
  if (copy != nullptr) *copy += takeWritten();
  // ImGui itself moves a panel that would be outside of a small window.
  const bool byHand = ImGui::IsWindowFocused() && ImGui::IsMouseDragging(ImGuiMouseButton_Left);
  ImGui::End();
  if (byHand && std::max(std::abs(slot.shownX - slot.x), std::abs(slot.shownY - slot.y)) > 1) slot.dragged = true;
  if (!open) return setOpen(which, false);
  if (slot.folded && onTitle && clicked()) show(which);
}

}  // namespace tyg
