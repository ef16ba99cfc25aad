// Linked programs, cached by file and defines, reloaded from disk on request.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gl/loader.h"
#include "gl/shader_source.h"

namespace fascia::gl {

/// Access of kernels to their inputs (SSBO reads cost llvmpipe 8 to 12 times a texelFetch of the same buffer).
enum class LoadPath { storage, texel };
const char* name_of(LoadPath path);     // "ssbo", "texel"
constexpr int kMostStorageBlocks = 14;  // limit for the blocks that a kernel reads or writes
/// Storage blocks on GPUs; texel fetches on llvmpipe, where storage reads cost 8 to 12 times as much, and on devices
/// with fewer blocks per kernel than kernels use: OpenGL 4.3 guarantees eight. Needs a current context.
LoadPath fitting_load_path();

/// Who adds the terms of sums. The groups of GPUs do so in their shared memory, which costs software renderers 20 times
/// as much as an invocation that adds on its own. The two orders differ in rounding.
enum class Sums { in_groups, in_invocations };
/// By the device alone, so that states do not depend on the load path. Needs a current context.
Sums fitting_sums();

class ProgramCache;

class Program {
 public:
  Program();
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  GLuint id() const { return id_; }
  const std::string& label() const { return label_; }  // "sim/step/predict.comp [DAMPING=1 ...]"
  /// Grows with every reload: bindings must be looked up again, and uniforms set again.
  unsigned generation() const { return generation_; }
  void use() const;
  const std::map<std::string, Texel>& declared() const { return declared_; }  // buffers, see ShaderText
  const std::map<std::string, std::string>& output_types() const { return output_types_; }
  const std::string& file() const { return file_; }  // of a compute program, with its defines
  bool fused() const { return file_.empty(); }
  /// Starts linking, if that was postponed: drivers may link in parallel to the program, and several programs at once.
  /// Throws Error if the text cannot be read.
  void begin_link() const;
  /// False while the driver reports that it is linking; true if linking has not begun.
  bool idle() const;
  /// Waits until the program is linked; starts linking if that was postponed. Throws Error.
  void require() const;
  /// Called before and after a run; the cache's FirstRuns is notified of code that has not run yet.
  void begin_run() const;
  void end_run() const { run_generation_ = generation_; }
  const Defines& defines() const { return defines_; }
  // Uniforms by name, kept by the program until it is reloaded; it need not be in use. Setting a uniform that the
  // program does not have has no effect (the driver may have optimized it away).
  void set(const char* name, float value) const;
  void set(const char* name, int value) const;
  void set(const char* name, unsigned value) const;
  void set(const char* name, float x, float y, float z, float w) const;
  void set_matrix(const char* name, const float* column_major_4x4) const;

 private:
  friend class ProgramCache;
  GLint location(const char* name) const;
  mutable std::map<std::string, GLint, std::less<>> locations_;  // of uniforms, -1 for missing ones
  ProgramCache* cache_ = nullptr;
  GLuint id_ = 0;
  /// Compiled and linked, result not queried yet.
  struct Link;
  mutable std::unique_ptr<Link> link_;
  unsigned generation_ = 0;
  mutable unsigned run_generation_ = 0;  // generation of the last run
  std::string label_;
  std::string file_;
  Defines defines_;
  std::map<std::string, Texel> declared_;
  std::map<std::string, std::string> output_types_;
};

class ProgramCache {
 public:
  /// `folder` is the shaders folder. `load_path` becomes READ_TEXELS 0 or 1 in every program, and TEXELS_IN_ORDER is 1
  /// on llvmpipe, where the fetches and stores of an invocation run in program order. `sums` becomes SUMS_IN_GROUPS.
  ProgramCache(std::filesystem::path folder, LoadPath load_path, Sums sums = fitting_sums());
  ~ProgramCache();
  ProgramCache(const ProgramCache&) = delete;
  ProgramCache& operator=(const ProgramCache&) = delete;
  LoadPath load_path() const { return load_path_; }
  bool sums_in_groups() const { return sums_ == Sums::in_groups; }
  /// Whether callers that record many passes should fuse them (fused_pass.h): compiling then takes two to three times
  /// as long. Initially off. `rare`: also passes that are not part of every step.
  void set_fusing(bool on, bool rare = true) {
    fusing_ = on;
    fusing_rare_ = on && rare;
  }
  bool fusing() const { return fusing_; }
  bool fusing_rare() const { return fusing_rare_; }

  /// Compiled at the first call, then kept at the same address. Throws Error with the variant and the log mapped to
  /// file:line.
  const Program& compute(const std::string& file, const Defines& defines = {});
  const Program& draw(const std::string& vertex_file, const std::string& fragment_file, const Defines& defines = {});
  /// A compute program made of several kernels by `read`, which is also called at every reload. `label` identifies the
  /// program.
  const Program& fused(const std::string& label, std::function<ShaderText(const std::filesystem::path& folder)> read);

  /// Compiles every cached program again from disk. A program that fails keeps its old code; returns the messages.
  std::vector<std::string> reload();
  std::size_t size() const;  // number of linked ones

  /// While an object exists, compute() only reads a program's text: the program is linked by begin_link(), or at its
  /// first use.
  class Postponed {
   public:
    explicit Postponed(ProgramCache& cache) : cache_(cache) { ++cache_.postponed_; }
    ~Postponed() { --cache_.postponed_; }
    Postponed(const Postponed&) = delete;
    Postponed& operator=(const Postponed&) = delete;

   private:
    ProgramCache& cache_;
  };

  /// While an object exists, `tell` is called before the first run of a compute program, which many drivers translate
  /// only then. `tell` may draw, but not run compute programs. One object at a time.
  class FirstRuns {
   public:
    FirstRuns(ProgramCache& cache, std::function<void()> tell) : cache_(cache) {
      cache_.tell_first_run_ = std::move(tell);
    }
    ~FirstRuns() { cache_.tell_first_run_ = nullptr; }
    FirstRuns(const FirstRuns&) = delete;
    FirstRuns& operator=(const FirstRuns&) = delete;

   private:
    ProgramCache& cache_;
  };

 private:
  struct Entry {
    std::vector<std::pair<GLenum, std::function<ShaderText()>>> stages;
    std::unique_ptr<Program> program;
  };
  const Program& get(const std::string& name, const std::vector<std::pair<GLenum, std::string>>& stages,
                     Defines defines);
  friend class Program;
  std::unique_ptr<Program::Link> begin_link(const Entry& entry) const;
  void finish(Program& program,
              std::unique_ptr<Program::Link> link) const;  // the program is unchanged if this throws

  std::filesystem::path folder_;
  LoadPath load_path_;
  Sums sums_;
  bool fusing_ = false, fusing_rare_ = false;
  int postponed_ = 0;
  std::function<void()> tell_first_run_;
  std::map<std::string, Entry> programs_;
};

}  // namespace fascia::gl
