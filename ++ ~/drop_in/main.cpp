#include <tight_inclusion/ccd.hpp>

#include <iostream>

int main() {
  const Eigen::Vector3d f0(-1, -1, 0), f1(1, -1, 0), f2(0, 1, 0);
  const Eigen::Array3d err(-1, -1, -1);
  double toi, output_tolerance;
  const bool hit = ticcd::vertexFaceCCD({0, 0, 1}, f0, f1, f2, {0, 0, -1}, f0, f1, f2, err, /*ms=*/0.125, toi,
                                        /*tolerance=*/1e-6, /*t_max=*/1, /*max_itr=*/1000000, output_tolerance);
  std::cout << (hit ? "within 1/8 at t = " : "free, ") << toi << '\n';
}
