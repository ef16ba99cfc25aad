#include "gl/program.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace fascia::gl {
namespace {

/// The lines of a driver's log as one line, for Error: without warnings if there are errors.
std::string one_line(const std::string& log) {
  const bool errors = log.find("error") != std::string::npos;
  std::string result, line;
  for (const char c : log + "\n") {
    if (c != '\n') {
      if (c != '\0' && c != '\r') line += c;
      continue;
    }
    if (line.find_first_not_of(" \t") != std::string::npos && !(errors && line.find("warning:") != std::string::npos))
      result += (result.empty() ? "" : " | ") + line;
    line.clear();
  }
  return result;
}

template <class GetInteger, class GetLog>
std::string log_of(GLuint id, GetInteger get_integer, GetLog get_log) {
  GLint length = 0;
  get_integer(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  get_log(id, static_cast<GLsizei>(log.size()), nullptr, log.data());
  return log;
}

constexpr GLenum kCompletionStatus = 0x91B1;  // of KHR_parallel_shader_compile

}  // namespace

const char* name_of(LoadPath path) { return path == LoadPath::storage ? "ssbo" : "texel"; }

LoadPath fitting_load_path() {
  return device().software || device().max_compute_storage_blocks < kMostStorageBlocks ? LoadPath::texel
                                                                                       : LoadPath::storage;
}

Sums fitting_sums() { return device().software ? Sums::in_invocations : Sums::in_groups; }

// Drivers that link on their own threads wait for them when the result is queried.
struct Program::Link {
  struct Stage {
    GLuint shader;
    ShaderText source;
  };
  Link() : id(CreateProgram()) {}
  ~Link() {
    for (const Stage& stage : stages) DeleteShader(stage.shader);
    if (id) DeleteProgram(id);
  }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  void compile(GLenum kind, ShaderText source) {
    const Stage& stage = stages.emplace_back(CreateShader(kind), std::move(source));
    const char* text = stage.source.text.c_str();
    ShaderSource(stage.shader, 1, &text, nullptr);
    CompileShader(stage.shader);
    AttachShader(id, stage.shader);
  }
  /// Throws Error with the driver's log of the first stage that fails.
  void require(const std::string& label) const {
    for (const Stage& stage : stages) {
      GLint done = 0;
      GetShaderiv(stage.shader, GL_COMPILE_STATUS, &done);
      if (done) continue;
      const std::string log = one_line(map_log(stage.source, log_of(stage.shader, GetShaderiv, GetShaderInfoLog)));
      throw Error((log.empty() ? "shaders/" + stage.source.lines.front().file + ": does not compile" : log) + "; in " +
                  label);
    }
    GLint done = 0;
    GetProgramiv(id, GL_LINK_STATUS, &done);
    if (!done)
      throw Error("shaders/" + label + ": does not link: " + one_line(log_of(id, GetProgramiv, GetProgramInfoLog)));
    for (const Stage& stage : stages) DetachShader(id, stage.shader);
  }

  GLuint id;
  std::vector<Stage> stages;
};

Program::Program() = default;
Program::~Program() {
  if (id_) DeleteProgram(id_);
}

void Program::use() const { UseProgram(id_); }
// Queried once: drivers with their own thread synchronize at each query.
GLint Program::location(const char* name) const {
  const auto found = locations_.find(name);
  if (found != locations_.end()) return found->second;
  return locations_.emplace(name, GetUniformLocation(id_, name)).first->second;
}

void Program::set(const char* name, float value) const { ProgramUniform1f(id_, location(name), value); }
void Program::set(const char* name, int value) const { ProgramUniform1i(id_, location(name), value); }
void Program::set(const char* name, unsigned value) const { ProgramUniform1ui(id_, location(name), value); }
void Program::set(const char* name, float x, float y, float z, float w) const {
  ProgramUniform4f(id_, location(name), x, y, z, w);
}
void Program::set_matrix(const char* name, const float* column_major_4x4) const {
  ProgramUniformMatrix4fv(id_, location(name), 1, GL_FALSE, column_major_4x4);
}

ProgramCache::ProgramCache(std::filesystem::path folder, LoadPath load_path, Sums sums)
    : folder_(std::move(folder)), load_path_(load_path), sums_(sums) {}

// A program that is in use outlives its deletion. NVIDIA's driver (580) then lets draws with later programs get lost.
ProgramCache::~ProgramCache() {
  if (!programs_.empty()) UseProgram(0);
}

const Program& ProgramCache::compute(const std::string& file, const Defines& defines) {
  return get(file, {{GL_COMPUTE_SHADER, file}}, defines);
}

const Program& ProgramCache::draw(const std::string& vertex_file, const std::string& fragment_file,
                                  const Defines& defines) {
  return get(vertex_file + " + " + fragment_file,
             {{GL_VERTEX_SHADER, vertex_file}, {GL_FRAGMENT_SHADER, fragment_file}}, defines);
}

const Program& ProgramCache::get(const std::string& name, const std::vector<std::pair<GLenum, std::string>>& stages,
                                 Defines defines) {
  std::sort(defines.begin(), defines.end());
  std::string label = name, list;
  for (const auto& [key, value] : defines) list += (list.empty() ? "" : " ") + key + "=" + value;
  if (!list.empty()) label += " [" + list + "]";
  const auto found = programs_.find(label);
  if (found != programs_.end()) {
    if (postponed_ == 0) found->second.program->require();
    return *found->second.program;
  }
  Entry entry{{}, std::make_unique<Program>()};
  entry.program->label_ = label;
  entry.program->file_ = name;
  entry.program->defines_ = defines;
  defines.emplace_back("READ_TEXELS", load_path_ == LoadPath::texel ? "1" : "0");
  defines.emplace_back("SUMS_IN_GROUPS", sums_in_groups() ? "1" : "0");
  defines.emplace_back("TEXELS_IN_ORDER", device().vector_width > 0 ? "1" : "0");
  for (const auto& [stage, file] : stages)
    entry.stages.emplace_back(stage, [this, file = file, defines] { return read_shader(folder_, file, defines); });
  entry.program->cache_ = this;
  if (postponed_ > 0) {
    const ShaderText text = entry.stages.front().second();
    entry.program->declared_ = text.declared;
    entry.program->output_types_ = text.output_types;
  } else {
    finish(*entry.program, begin_link(entry));
  }
  return *programs_.emplace(label, std::move(entry)).first->second.program;
}

void Program::begin_link() const {
  if (!id_ && !link_ && cache_) link_ = cache_->begin_link(cache_->programs_.at(label_));
}

bool Program::idle() const {
  if (!link_ || !device().links_beside) return true;
  GLint done = 0;
  GetProgramiv(link_->id, kCompletionStatus, &done);
  return done;
}

void Program::require() const {
  begin_link();
  if (link_) cache_->finish(*cache_->programs_.at(label_).program, std::move(link_));
}

void Program::begin_run() const {
  const bool has_run = id_ && run_generation_ == generation_;
  if (!has_run && cache_ && cache_->tell_first_run_) cache_->tell_first_run_();
}

std::size_t ProgramCache::size() const {
  return static_cast<std::size_t>(std::count_if(programs_.begin(), programs_.end(),
                                                [](const auto& entry) { return entry.second.program->id() != 0; }));
}

const Program& ProgramCache::fused(const std::string& label,
                                   std::function<ShaderText(const std::filesystem::path&)> read) {
  const auto found = programs_.find(label);
  if (found != programs_.end()) return *found->second.program;
  Entry entry{{{GL_COMPUTE_SHADER, [this, read = std::move(read)] { return read(folder_); }}},
              std::make_unique<Program>()};
  entry.program->label_ = label;
  entry.program->cache_ = this;
  finish(*entry.program, begin_link(entry));
  return *programs_.emplace(label, std::move(entry)).first->second.program;
}

std::unique_ptr<Program::Link> ProgramCache::begin_link(const Entry& entry) const {
  auto link = std::make_unique<Program::Link>();
  for (const auto& [stage, read] : entry.stages) link->compile(stage, read());
  LinkProgram(link->id);
  return link;
}

void ProgramCache::finish(Program& program, std::unique_ptr<Program::Link> link) const {
  link->require(program.label_);
  if (program.id_) DeleteProgram(program.id_);
  program.id_ = std::exchange(link->id, 0);
  ObjectLabel(GL_PROGRAM, program.id_, static_cast<GLsizei>(std::min<std::size_t>(program.label_.size(), 100)),
              program.label_.c_str());
  program.locations_.clear();
  program.declared_.clear();
  program.output_types_.clear();
  for (Program::Link::Stage& stage : link->stages) {
    program.declared_.merge(stage.source.declared);
    program.output_types_.merge(stage.source.output_types);
  }
  ++program.generation_;
}

std::vector<std::string> ProgramCache::reload() {
  std::vector<std::string> messages;
  for (const auto& [label, entry] : programs_) {
    if (!entry.program->id()) continue;  // read at its first use
    try {
      finish(*entry.program, begin_link(entry));
    } catch (const Error& error) {
      messages.push_back(error.what());
    }
  }
  return messages;
}

}  // namespace fascia::gl
