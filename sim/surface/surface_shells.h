// Which shell lies around which: a tree of their boxes, so that not every shell is compared with every other one.
#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <vector>

namespace fascia {

class ShellTree {
 public:
  struct Shell {
    Eigen::AlignedBox3d box;
    double area;
    std::uint32_t number;
  };
  static constexpr std::uint32_t kNone = ~0u;

  explicit ShellTree(std::vector<Shell> shells);

  /// Number of the shell of the largest area beyond `area` whose box contains `box` and for which holds(number); among
  /// equal ones the first. `holds` is asked in the order of areas, until it says yes.
  std::uint32_t largest_around(const Eigen::AlignedBox3d& box, double area,
                               const std::function<bool(std::uint32_t)>& holds) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;   // around all boxes
    double area;               // the largest
    std::uint32_t begin, end;  // in shells_
    std::uint32_t right = 0;   // child; the left one follows its parent; 0: a leaf
  };
  void build(std::uint32_t begin, std::uint32_t end);

  std::vector<Shell> shells_;
  std::vector<Node> nodes_;
};

}  // namespace fascia
