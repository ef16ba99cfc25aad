// Finds the shell around each shell with a tree of their boxes, so that not all shells are compared with each other.
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

  /// The number of the largest shell beyond `area` whose box contains `box` and for which holds(number) is true; among
  /// equal areas the first. `holds` is called in the order of areas until it returns true.
  std::uint32_t largest_around(const Eigen::AlignedBox3d& box, double area,
                               const std::function<bool(std::uint32_t)>& holds) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;   // around all boxes
    double area;               // the largest
    std::uint32_t begin, end;  // in shells_
    std::uint32_t right = 0;   // right child; the left one follows its parent; 0: a leaf
  };
  void build(std::uint32_t begin, std::uint32_t end);

  std::vector<Shell> shells_;
  std::vector<Node> nodes_;
};

}  // namespace fascia
