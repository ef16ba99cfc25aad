// Figures of kernels as compilers of graphics chips state them, in a table that is kept beside the test.
#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/support/gpu/kernel_texts.h"

namespace fascia::test {

/// Chips that Mesa's driver for AMD compiles for: RDNA 2 and Vega. For RDNA 3, Mesa 22.3 uses half of a chip's
/// registers and spills the rest.
constexpr std::array<const char*, 2> kChips{"NAVI21", "VEGA10"};

struct ChipFigures {
  int registers = 0;  // vector registers of an invocation
  int waves = 0;      // that a SIMD unit holds at once
  int lds_bytes = 0;  // shared memory of a work group
  int spills = 0;     // spilled registers and bytes of scratch memory; not in the table
};

/// Of Tiger Lake (Xe-LP). The wider, the fewer instructions for as many invocations: the compiler takes the widest code
/// that fits into 128 registers of 32 bytes.
struct IntelFigures {
  int width = 0;  // invocations that an instruction computes at once: SIMD8, 16 or 32
  int instructions = 0;
  int spills = 0, fills = 0;  // stores and loads of registers that do not fit
};

struct KernelFigures {
  std::array<ChipFigures, kChips.size()> chips;  // 0 without that driver
  IntelFigures intel;                            // 0 without that driver
};
using KernelTable = std::map<KernelName, KernelFigures>;

/// Registers more than in the table that a change of the compiler's order of instructions may cost.
constexpr int kMoreRegisters = 8;

/// One line for every kernel that spills, needs kMoreRegisters more than in the table, is less wide than there, or is
/// in one table only.
std::vector<std::string> complaints(const KernelTable& table, const KernelTable& now);

struct StoredTable {
  std::string driver;  // whose figures they are: "Mesa 22.3.6"
  KernelTable kernels;
};
StoredTable read_table(const std::filesystem::path& file);
void write_table(const std::filesystem::path& file, const StoredTable& table);

/// Rows of Markdown: of every kernel with more than `least` registers on the first chip its most demanding variant.
std::vector<std::string> summary(const KernelTable& table, int least);

}  // namespace fascia::test
