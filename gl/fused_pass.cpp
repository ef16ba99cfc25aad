#include "gl/fused_pass.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <functional>
#include <optional>
#include <thread>

#include "base/error.h"
#include "gl/fused_source.h"

namespace fascia::gl {
namespace fused {  // named, because a class with external linkage has members of these types

// Constants of shaders/common/fused.glsl.
constexpr std::uint32_t kKernelShift = 12, kNoKernel = 0xfffff;  // bits of the current kernel, its value at the end
// Counters of the work groups taken: beside the first word they would slow down the groups that wait for it
constexpr std::uint32_t kFirstCounter = 16;
constexpr std::uint32_t kMostLoops = 50'000;   // iterations per work group
constexpr std::uint32_t kLoopsOfAKernel = 16;  // each of its own loops runs at least once, even without work
constexpr std::uint32_t kMostAtOnce = kMostLoops / 8;

// The number of llvmpipe's threads.
std::uint32_t crew_size() {
  const char* threads = std::getenv("LP_NUM_THREADS");
  return std::clamp(
      threads ? static_cast<unsigned>(std::max(0, std::atoi(threads))) : std::thread::hardware_concurrency(), 1u, 16u);
}
std::uint32_t group_size() { return static_cast<std::uint32_t>(device().vector_width); }
std::uint32_t groups_of(std::uint32_t invocations) { return (invocations + group_size() - 1) / group_size(); }

// The buffers of a fused program, each declared once per kind of access.
class Declarations {
 public:
  std::string input(const Buffer& buffer, Texel texel) {
    const Texel kind = texel == Texel::vec4_in_place ? Texel::vec4 : texel;
    return name(buffer, kind,
                kind == Texel::uvec4 || kind == Texel::uint1 ? "uniform usamplerBuffer" : "uniform samplerBuffer");
  }
  std::string output(const Buffer& buffer, const std::string& type) { return name(buffer, Texel::none, type); }

  std::size_t inputs() const { return count(true); }
  std::size_t outputs() const { return count(false); }
  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (const Declared& d : all_)
      lines.push_back(d.texel == Texel::none ? "layout(std430) coherent buffer " + pascal_case(d.name) + " { " +
                                                   d.type + " " + d.name + "[]; };"
                                             : d.type + " " + d.name + ";");
    return lines;
  }
  ComputePass::Bindings bindings() const {
    ComputePass::Bindings bindings;
    for (const Declared& d : all_) bindings.emplace_back(d.name, d.buffer);
    return bindings;
  }
  std::map<std::string, Texel> declared() const {
    std::map<std::string, Texel> declared;
    for (const Declared& d : all_) declared.emplace(d.name, d.texel);
    return declared;
  }

 private:
  struct Declared {
    const Buffer* buffer;
    Texel texel;  // none: an output
    std::string type, name;
  };
  std::string name(const Buffer& buffer, Texel texel, const std::string& type) {
    for (const Declared& d : all_)
      if (d.buffer == &buffer && d.texel == texel && d.type == type) return d.name;
    all_.push_back({&buffer, texel, type, (texel == Texel::none ? "written_" : "read_") + std::to_string(all_.size())});
    return all_.back().name;
  }
  std::size_t count(bool inputs) const {
    const auto counts = [&](const Declared& d) { return (d.texel != Texel::none) == inputs; };
    return static_cast<std::size_t>(std::count_if(all_.begin(), all_.end(), counts));
  }
  std::vector<Declared> all_;
};

// A value of the plan.
struct Word {
  std::uint32_t value = 0;
  const std::uint32_t* followed = nullptr;
  bool groups = false;  // number of groups instead of invocations
};

struct Run {
  std::size_t kernel;
  std::vector<Word> record;
};

// The kernels, their schedule and their resources.
struct Composition {
  Declarations declarations;
  std::vector<FusedKernel> kernels;
  std::vector<Run> runs;
  const Buffer* step = nullptr;  // the uniform block of all kernels

  bool fits() const {
    return declarations.outputs() + 1 <=
               static_cast<std::size_t>(device().max_compute_storage_blocks) &&                     // plus the crew
           declarations.inputs() + 1 <= static_cast<std::size_t>(device().max_compute_textures) &&  // plus the plan
           runs.size() * kLoopsOfAKernel <= kMostAtOnce;
  }

  const Program& program(ProgramCache& programs, const std::vector<FusedLoop>& loops) const {
    return programs.fused(label(loops), [lines = declarations.lines(), kernels = kernels, loops, step = step != nullptr,
                                         declared = declarations.declared()](const std::filesystem::path& folder) {
      Defines defines{{"READ_TEXELS", "1"}, {"TEXELS_IN_ORDER", "1"}, {"SUMS_IN_GROUPS", "0"}};
      for (const auto& [name, value] :
           {std::pair("GROUP_SIZE", group_size()), std::pair("KERNEL_SHIFT", kKernelShift),
            std::pair("NO_KERNEL", kNoKernel), std::pair("FIRST_COUNTER", kFirstCounter),
            std::pair("MOST_LOOPS", kMostLoops), std::pair("LOOPS_OF_A_KERNEL", kLoopsOfAKernel)})
        defines.emplace_back(name, std::to_string(value) + "u");
      ShaderText text = read_fused(folder, defines, lines, step, kernels, loops);
      text.declared = declared;
      text.declared.insert({{"crew", Texel::none}, {"plan", Texel::uint1}});
      return text;
    });
  }

  void add(const ComputePass& pass) {
    const auto [from, to] = pass.copied();
    if (to) add_copy(*from, *to);
    FusedKernel kernel{pass.program().file(), {}, {}, {}, {}};
    for (const auto& define : pass.program().defines())
      if (define.first != "GROUP_SIZE") kernel.defines.push_back(define);
    for (const auto& [name, buffer] : pass.bindings()) {
      const auto declared = pass.program().declared().find(name);
      if (declared != pass.program().declared().end()) {
        kernel.buffers[name] = declared->second == Texel::none
                                   ? declarations.output(*buffer, pass.program().output_types().at(name))
                                   : declarations.input(*buffer, declared->second);
        continue;
      }
      if (name != "step")
        throw Error("kernel " + pass.program().label(), "has no buffer named " + name,
                    "expected a name that the kernel declares");
      if (step && step != buffer)
        throw Error("kernel " + pass.program().label(), "another step buffer", "expected one for all fused kernels");
      step = buffer;
    }
    // Not read as a texel: outside conditions the compiler mistakes a second fetch from one place for the first.
    if (pass.arguments()) kernel.groups = declarations.output(*pass.arguments(), "uint");
    std::vector<Word> record(3);
    record[2].value = 1 + *pass.loops();
    for (const auto& [name, value] : pass.constants()) {
      Word word{value};
      for (const auto& [constant, followed] : pass.followed())
        if (constant == name) word.followed = followed;
      kernel.constants.push_back(name);
      record.push_back(word);
      if (name != "invocations") continue;
      word.groups = true;
      record[0] = word;
    }
    for (const auto& [name, followed] : pass.followed())
      if (std::find(kernel.constants.begin(), kernel.constants.end(), name) == kernel.constants.end()) {
        kernel.constants.push_back(name);
        record.push_back({0, followed, false});
      }
    if (pass.arguments()) record[0] = {pass.first_argument()};
    record[1].value = std::max(1u, kMostAtOnce / record[2].value);
    add(std::move(kernel), std::move(record));
  }

 private:
  // "fused predict, elastic_force, ... (1906...)", with a fingerprint of all inputs of the text.
  std::string label(const std::vector<FusedLoop>& loops) const {
    std::string names, all;
    for (const std::string& line : declarations.lines()) all += line + "\n";
    for (const FusedKernel& kernel : kernels) {
      names += (names.empty() ? "" : ", ") + std::filesystem::path(kernel.file).stem().string();
      all += kernel.file + " " + kernel.groups;
      for (const auto& [name, value] : kernel.defines) all += " " + name + "=" + value;
      for (const auto& [name, fused] : kernel.buffers) all += " " + name + "=" + fused;
      for (const std::string& constant : kernel.constants) all += " " + constant;
    }
    for (const FusedLoop& loop : loops) {
      all += "\n";
      for (const std::size_t kernel : loop) all += std::to_string(kernel) + " ";
    }
    return "fused " + names + " (" + std::to_string(std::hash<std::string>{}(all)) + ")";
  }
  void add(FusedKernel kernel, std::vector<Word> record) {
    const auto found = std::find(kernels.begin(), kernels.end(), kernel);
    runs.push_back({static_cast<std::size_t>(found - kernels.begin()), std::move(record)});
    if (found == kernels.end()) kernels.push_back(std::move(kernel));
  }
  void add_copy(const Buffer& from, const Buffer& to) {
    const std::vector<std::uint32_t> words = from.read<std::uint32_t>();
    constexpr std::size_t kPattern = 4;
    for (std::size_t k = 0; k < words.size(); ++k)
      if (words.size() % kPattern != 0 || words[k] != words[k % kPattern])
        throw Error("fused " + to.label(), "what it is to be filled with",
                    "expected the same four words again and again");
    const auto repeats = static_cast<std::uint32_t>(words.size() / kPattern);
    FusedKernel kernel{"common/fill.comp", {}, {{"filled", declarations.output(to, "uint")}}, {"invocations"}, {}};
    std::vector<Word> record{{repeats, nullptr, true}, {kMostAtOnce}, {1}, {repeats}};
    for (std::size_t k = 0; k < kPattern; ++k) {
      kernel.constants.push_back("word_" + std::to_string(k));
      record.push_back({words[k]});
    }
    add(std::move(kernel), std::move(record));
  }
};

// Combines consecutive runs of a kernel, or of up to four kernels in turn, to loops.
struct Schedule {
  std::vector<FusedLoop> loops;
  std::vector<std::uint32_t> turns;

  explicit Schedule(const std::vector<Run>& runs) {
    for (std::size_t i = 0; i < runs.size();) {
      std::size_t best = 1, best_turns = 1;
      for (std::size_t period = 1; period <= 4; ++period) {
        std::size_t same = 0;
        while (i + period + same < runs.size() && runs[i + period + same].kernel == runs[i + same].kernel) ++same;
        const std::size_t turns_now = 1 + same / period;
        if (turns_now > 1 && turns_now * period > best * best_turns) best = period, best_turns = turns_now;
      }
      FusedLoop loop;
      for (std::size_t k = 0; k < best; ++k) loop.push_back(runs[i + k].kernel);
      loops.push_back(std::move(loop));
      turns.push_back(static_cast<std::uint32_t>(best_turns));
      i += best * best_turns;
    }
  }
};

}  // namespace fused

using namespace fused;

bool fuses(const ProgramCache& programs) {
  return programs.fusing() && programs.load_path() == LoadPath::texel && !programs.sums_in_groups() &&
         device().vector_width > 0;
}

class FusedPasses::Dispatch {
 public:
  explicit Dispatch(ComputePass alone) : alone_(std::move(alone)) { alone_->prepare(); }
  Dispatch(ProgramCache& programs, const Composition& composition) {
    const Schedule schedule(composition.runs);
    words_.push_back({static_cast<std::uint32_t>(composition.runs.size())});
    for (const std::uint32_t turns : schedule.turns) words_.push_back({turns});
    for (const Run& run : composition.runs) words_.insert(words_.end(), run.record.begin(), run.record.end());
    for (std::size_t k = 0; k < words_.size(); ++k) {
      values_.push_back(value(k));
      if (words_[k].followed) followed_.push_back(k);
    }
    plan_ = Buffer("plan", values_);
    const std::uint32_t counters = (most_repeats() * words_.front().value + 15) / 16 * 16;  // per stretch: fused.glsl
    crew_ = Buffer("crew", sizeof(std::uint32_t) * (kFirstCounter + std::bit_ceil((crew_size() + 1) / 2) * counters));
    ComputePass::Bindings bindings = composition.declarations.bindings();
    bindings.insert(bindings.end(), {{"crew", &crew_}, {"plan", &plan_}});
    if (composition.step) bindings.emplace_back("step", composition.step);
    together_.emplace(composition.program(programs, schedule.loops), std::move(bindings), group_size() * crew_size(),
                      ComputePass::Constants{{"repeats", 1}});
    together_->follow("repeats", repeats_);
  }

  /// In one dispatch.
  std::uint32_t most_repeats() const {
    return alone_ ? 1 : std::max(1u, kMostAtOnce / kLoopsOfAKernel / words_.front().value);
  }

  void run(std::uint32_t repeats) const {
    if (alone_) {
      alone_->run();
      return;
    }
    bool changed = false;
    for (const std::size_t k : followed_) {
      changed |= values_[k] != value(k);
      values_[k] = value(k);
    }
    if (changed) plan_.upload(0, values_.size() * sizeof(std::uint32_t), values_.data());
    repeats_ = repeats;
    crew_.clear();
    constexpr int kMostDispatches = 1 << 20;
    for (int i = 0; i < kMostDispatches; ++i) {
      together_->run();
      std::uint32_t word = 0;
      crew_.download(0, sizeof word, &word);
      if (word >> kKernelShift == kNoKernel) return;
    }
    require_context();
    throw Error("kernel " + together_->program().label() + ": comes to no end");
  }

 private:
  std::uint32_t value(std::size_t k) const {
    const std::uint32_t value = words_[k].followed ? *words_[k].followed : words_[k].value;
    return words_[k].groups ? groups_of(value) : value;
  }

  std::optional<ComputePass> alone_, together_;
  std::vector<Word> words_;                    // the plan
  std::vector<std::size_t> followed_;          // words that may change
  mutable std::vector<std::uint32_t> values_;  // of its words, as uploaded to plan_
  mutable Buffer plan_, crew_;                 // uint: see fused.glsl
  mutable std::uint32_t repeats_ = 1;
};

FusedPasses::FusedPasses(ProgramCache& programs, const std::vector<ComputePass>& passes) {
  for (std::size_t begin = 0; begin < passes.size();) {
    Composition composition;
    std::size_t end = begin;
    for (; end < passes.size() && passes[end].loops() && *passes[end].loops() < kMostAtOnce; ++end) {
      Composition more = composition;
      more.add(passes[end]);
      if (!more.fits()) break;
      composition = std::move(more);
    }
    if (end > begin + 1) {
      dispatches_.push_back(std::make_shared<Dispatch>(programs, composition));
      begin = end;
    } else {
      dispatches_.push_back(std::make_shared<Dispatch>(passes[begin++]));
    }
  }
}

void FusedPasses::run(std::uint32_t repeats) const {
  const std::uint32_t at_once = dispatches_.size() == 1 ? dispatches_.front()->most_repeats() : 1;
  for (std::uint32_t done = 0; done < repeats; done += at_once)
    for (const auto& dispatch : dispatches_) dispatch->run(std::min(at_once, repeats - done));
}

std::uint64_t FusedPasses::dispatches(std::uint32_t repeats) const {
  if (dispatches_.size() != 1) return repeats * dispatches_.size();
  const std::uint32_t at_once = dispatches_.front()->most_repeats();
  return (repeats + at_once - 1) / at_once;
}

}  // namespace fascia::gl
