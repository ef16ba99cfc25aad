// A vertex array object, and the calls that fill it.
#pragma once
#include "gl/buffer.h"

namespace fascia {

class VertexArray {
 public:
  VertexArray() { gl::GenVertexArrays(1, &id_); }
  ~VertexArray() { gl::DeleteVertexArrays(1, &id_); }
  VertexArray(const VertexArray&) = delete;
  VertexArray& operator=(const VertexArray&) = delete;

  void bind() const { gl::BindVertexArray(id_); }
  /// The four floats of each vertex.
  void set_vec4(GLuint location, const gl::Buffer& buffer) const {
    bind();
    gl::BindBuffer(GL_ARRAY_BUFFER, buffer.id());
    gl::VertexAttribPointer(location, 4, GL_FLOAT, GL_FALSE, 16, nullptr);
    gl::EnableVertexAttribArray(location);
  }
  /// One number per instance.
  void set_instance_uint(GLuint location, const gl::Buffer& buffer) const {
    bind();
    gl::BindBuffer(GL_ARRAY_BUFFER, buffer.id());
    gl::VertexAttribIPointer(location, 1, GL_UNSIGNED_INT, 4, nullptr);
    gl::VertexAttribDivisor(location, 1);
    gl::EnableVertexAttribArray(location);
  }
  void set_indices(const gl::Buffer& buffer) const {
    bind();
    gl::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.id());
  }

 private:
  GLuint id_ = 0;
};

}  // namespace fascia
