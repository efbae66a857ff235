// Cells without a cut are drawn from the particles as they are, by a list of triangles that stays; what is beside cuts
// has vertices of its own, which are few.
#include "gfx/passes/cloth_mesh.h"

#include <cstddef>

namespace tyg {
namespace {

enum Attribute : GLuint {
  PositionAttribute = 0,
  NormalAttribute,
  PlaceAttribute,
  ParticleAttribute
};  // of surface.vert

const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): OpenGL's way
}

void useFloats(Attribute attribute, int count, std::size_t stride, std::size_t from) {
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, count, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), offset(from));
}

template <class Element>
void fill(GLenum target, const std::vector<Element>& elements, GLenum usage) {
  glBufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(), usage);
}

}  // namespace

void ClothMesh::makeObjects() {
  objects_.emplace();
  glBindVertexArray(objects_->whole.name());
  glBindBuffer(GL_ARRAY_BUFFER, particles_.buffer());
  useFloats(PositionAttribute, 3, 0, 0);
  glBindBuffer(GL_ARRAY_BUFFER, objects_->normals.name());
  useFloats(NormalAttribute, 3, 0, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, objects_->triangles.name());
  glBindVertexArray(objects_->beside.name());
  glBindBuffer(GL_ARRAY_BUFFER, objects_->pieces.name());
  useFloats(PositionAttribute, 3, sizeof(ClothVertex), offsetof(ClothVertex, position));
  useFloats(NormalAttribute, 3, sizeof(ClothVertex), offsetof(ClothVertex, normal));
  useFloats(PlaceAttribute, 2, sizeof(ClothVertex), offsetof(ClothVertex, place));
  glEnableVertexAttribArray(ParticleAttribute);
  glVertexAttribIPointer(ParticleAttribute, 1, GL_UNSIGNED_INT, sizeof(ClothVertex),
                         offset(offsetof(ClothVertex, particle)));
}

void ClothMesh::prepare(const Sheet& sheet, const DrawnPositions& particles) {
  if (!objects_) makeObjects();
  if (!surface_) {
    columns_ = sheet.columns;
    surface_.emplace(sheet);
    glBindVertexArray(objects_->whole.name());
    fill(GL_ELEMENT_ARRAY_BUFFER, surface_->triangles(), GL_STATIC_DRAW);
  }
  glBindVertexArray(0);
  if (particles.buffer() != 0 && sheet.missing.none()) return computeNormals(sheet);
  surface_->follow(particles.xyz());
  glBindBuffer(GL_ARRAY_BUFFER, objects_->normals.name());
  fill(GL_ARRAY_BUFFER, surface_->normals(), GL_STREAM_DRAW);
  if (surface_->pieces().empty()) return;
  glBindBuffer(GL_ARRAY_BUFFER, objects_->pieces.name());
  fill(GL_ARRAY_BUFFER, surface_->pieces(), GL_STREAM_DRAW);
}

void ClothMesh::computeNormals(const Sheet& sheet) const {
  const GLuint normals = objects_->normals.name();
  glBindBuffer(GL_ARRAY_BUFFER, normals);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr{3} * sheet.count() * GLsizeiptr{sizeof(float)}, nullptr, GL_STREAM_COPY);
  const GlProgram& program = programs_.get("normals", {}, "normal");
  program.use();
  program.set("positions", 0);
  program.set("columns", sheet.columns);
  program.set("rows", sheet.rows);
  program.set("scale", 1 / static_cast<float>(sheet.spacing));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_BUFFER, particles_.texture());
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, normals);
  glBindVertexArray(objects_->nothing.name());
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, sheet.count());
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
}

void ClothMesh::draw(const GlProgram& program) const {
  program.set("columns", columns_);
  program.set("besideCut", 0);
  glBindVertexArray(objects_->whole.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(surface_->triangles().size()), GL_UNSIGNED_INT, nullptr);
  if (surface_->pieces().empty()) return;
  program.set("besideCut", 1);
  glBindVertexArray(objects_->beside.name());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(surface_->pieces().size()));
}

}  // namespace tyg
