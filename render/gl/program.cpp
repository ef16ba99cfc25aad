#include "render/gl/program.h"

#include <algorithm>

#include "sim/error.h"

namespace fascia::gl {
namespace {

/// The lines of a driver's log as one line, for Error: without warnings, where there are errors.
std::string one_line(const std::string& log) {
  const bool errors = log.find("error") != std::string::npos;
  std::string result, line;
  for (const char c : log + "\n") {
    if (c != '\n') {
      if (c != '\0' && c != '\r') line += c;
      continue;
    }
    if (line.find_first_not_of(" \t") != std::string::npos && !(errors && line.find("warning:") != std::string::npos)) result += (result.empty() ? "" : " | ") + line;
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

struct Shader {
  explicit Shader(GLenum stage) : id(CreateShader(stage)) {}
  ~Shader() { DeleteShader(id); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  const GLuint id;
};

void compile(const Shader& shader, const ShaderText& source, const std::string& label) {
  const char* text = source.text.c_str();
  ShaderSource(shader.id, 1, &text, nullptr);
  CompileShader(shader.id);
  GLint done = 0;
  GetShaderiv(shader.id, GL_COMPILE_STATUS, &done);
  if (done) return;
  const std::string log = one_line(map_log(source, log_of(shader.id, GetShaderiv, GetShaderInfoLog)));
  throw Error((log.empty() ? "shaders/" + source.lines.front().file + ": does not compile" : log) + "; in " +
              label);
}

}  // namespace

const char* name_of(LoadPath path) {
  return path == LoadPath::storage ? "ssbo" : "texel";
}

Program::~Program() {
  if (id_) DeleteProgram(id_);
}

void Program::use() const {
  UseProgram(id_);
}
// Asked once: with drivers that work on a thread of their own, each question waits for it.
GLint Program::location(const char* name) const {
  const auto found = locations_.find(name);
  if (found != locations_.end()) return found->second;
  return locations_.emplace(name, GetUniformLocation(id_, name)).first->second;
}

void Program::set(const char* name, float value) const {
  ProgramUniform1f(id_, location(name), value);
}
void Program::set(const char* name, int value) const {
  ProgramUniform1i(id_, location(name), value);
}
void Program::set(const char* name, unsigned value) const {
  ProgramUniform1ui(id_, location(name), value);
}
void Program::set(const char* name, float x, float y, float z, float w) const {
  ProgramUniform4f(id_, location(name), x, y, z, w);
}
void Program::set_matrix(const char* name, const float* column_major_4x4) const {
  ProgramUniformMatrix4fv(id_, location(name), 1, GL_FALSE, column_major_4x4);
}

ProgramCache::ProgramCache(std::filesystem::path folder, LoadPath load_path)
    : folder_(std::move(folder)), load_path_(load_path) {}

const Program& ProgramCache::compute(const std::string& file, const Defines& defines) {
  return get(file, {{GL_COMPUTE_SHADER, file}}, defines);
}

const Program& ProgramCache::draw(const std::string& vertex_file, const std::string& fragment_file,
                                  const Defines& defines) {
  return get(vertex_file + " + " + fragment_file,
             {{GL_VERTEX_SHADER, vertex_file}, {GL_FRAGMENT_SHADER, fragment_file}}, defines);
}

const Program& ProgramCache::get(const std::string& name, const std::vector<std::pair<GLenum, std::string>>& stages, Defines defines) {
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
  for (const auto& [stage, file] : stages)
    entry.stages.emplace_back(stage, [this, file = file, defines] { return read_shader(folder_, file, defines); });
  entry.program->cache_ = this;
  if (postponed_ > 0) {
    const ShaderText text = entry.stages.front().second();
    entry.program->declared_ = text.declared;
    entry.program->output_types_ = text.output_types;
  } else {
    link(entry);
  }
  return *programs_.emplace(label, std::move(entry)).first->second.program;
}

void Program::require() const {
  if (!id_ && cache_) cache_->link(cache_->programs_.at(label_));
}

void Program::begin_run() const {
  const bool has_run = id_ && run_generation_ == generation_;
  if (!has_run && cache_ && cache_->tell_first_run_) cache_->tell_first_run_();
}

std::size_t ProgramCache::size() const {
  return static_cast<std::size_t>(std::count_if(programs_.begin(), programs_.end(), [](const auto& entry) { return entry.second.program->id() != 0; }));
}

const Program& ProgramCache::fused(const std::string& label, std::function<ShaderText(const std::filesystem::path&)> read) {
  const auto found = programs_.find(label);
  if (found != programs_.end()) return *found->second.program;
  Entry entry{{{GL_COMPUTE_SHADER, [this, read = std::move(read)] { return read(folder_); }}}, std::make_unique<Program>()};
  entry.program->label_ = label;
  entry.program->cache_ = this;
  link(entry);
  return *programs_.emplace(label, std::move(entry)).first->second.program;
}

void ProgramCache::link(const Entry& entry) const {
  Program& program = *entry.program;
  std::map<std::string, Texel> declared;
  std::map<std::string, std::string> output_types;
  std::vector<std::unique_ptr<Shader>> shaders;
  for (const auto& [stage, read] : entry.stages) {
    const ShaderText source = read();
    compile(*shaders.emplace_back(std::make_unique<Shader>(stage)), source, program.label_);
    declared.insert(source.declared.begin(), source.declared.end());
    output_types.insert(source.output_types.begin(), source.output_types.end());
  }
  const GLuint id = CreateProgram();
  for (const auto& shader : shaders) AttachShader(id, shader->id);
  LinkProgram(id);
  for (const auto& shader : shaders) DetachShader(id, shader->id);
  GLint done = 0;
  GetProgramiv(id, GL_LINK_STATUS, &done);
  if (!done) {
    const std::string log = one_line(log_of(id, GetProgramiv, GetProgramInfoLog));
    DeleteProgram(id);
    throw Error("shaders/" + program.label_ + ": does not link: " + log);
  }
  ObjectLabel(GL_PROGRAM, id, static_cast<GLsizei>(std::min<std::size_t>(program.label_.size(), 100)),
              program.label_.c_str());
  if (program.id_) DeleteProgram(program.id_);
  program.id_ = id;
  program.locations_.clear();
  program.declared_ = std::move(declared);
  program.output_types_ = std::move(output_types);
  ++program.generation_;
}

std::vector<std::string> ProgramCache::reload() {
  std::vector<std::string> messages;
  for (const auto& [label, entry] : programs_) {
    if (!entry.program->id()) continue;  // read when it is first used
    try {
      link(entry);
    } catch (const Error& error) {
      messages.push_back(error.what());
    }
  }
  return messages;
}

}  // namespace fascia::gl
