// Linked programs, cached by file and defines, reloaded from disk on demand.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "render/gl/loader.h"
#include "render/gl/shader_source.h"

namespace fascia::gl {

/// How kernels read their inputs (platform fact: SSBO reads cost llvmpipe 8 to 12 times a texelFetch of the
/// same buffer).
enum class LoadPath { storage, texel };
const char* name_of(LoadPath path);  // "ssbo", "texel"

class Program {
 public:
  Program() = default;
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  GLuint id() const { return id_; }
  const std::string& label() const { return label_; }  // "sim/predict.comp [DAMPING=1 ...]"
  /// Grows with every reload: bindings must be looked up again, and uniforms set again.
  unsigned generation() const { return generation_; }
  void use() const;
  const std::map<std::string, Texel>& declared() const { return declared_; }  // buffers, see ShaderText
  // Uniforms by name, kept by the program until it is reloaded; it need not be in use. Setting one that the
  // program does not have does nothing (the driver may have optimised it away).
  void set(const char* name, float value) const;
  void set(const char* name, int value) const;
  void set(const char* name, unsigned value) const;
  void set(const char* name, float x, float y, float z, float w) const;
  void set_matrix(const char* name, const float* column_major_4x4) const;

 private:
  friend class ProgramCache;
  GLuint id_ = 0;
  unsigned generation_ = 0;
  std::string label_;
  std::map<std::string, Texel> declared_;
};

class ProgramCache {
 public:
  /// `folder` is the shaders folder. `load_path` becomes READ_TEXELS 0 or 1 in every program.
  ProgramCache(std::filesystem::path folder, LoadPath load_path);
  LoadPath load_path() const { return load_path_; }

  /// Compiled at the first call, then kept at the same address. Throws Error with the log mapped to file:line
  /// and the variant.
  const Program& compute(const std::string& file, const Defines& defines = {});
  const Program& draw(const std::string& vertex_file, const std::string& fragment_file,
                      const Defines& defines = {});

  /// Compiles every cached program again from disk. One that fails keeps its old code; returns the messages.
  std::vector<std::string> reload();
  std::size_t size() const { return programs_.size(); }

 private:
  struct Entry {
    std::vector<std::pair<GLenum, std::string>> stages;
    Defines defines;
    std::unique_ptr<Program> program;
  };
  const Program& get(const std::string& name, std::vector<std::pair<GLenum, std::string>> stages,
                     const Defines& defines);
  void link(const Entry& entry) const;  // into entry.program, which stays as it is when this throws

  std::filesystem::path folder_;
  LoadPath load_path_;
  std::map<std::string, Entry> programs_;
};

}  // namespace fascia::gl
