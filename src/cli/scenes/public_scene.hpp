// Scenes of the public time-of-impact data set (Belgrod et al. 2023), as its files come.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <touchstone/mesh.hpp>

namespace touchstone::cli {

/// A pair of elements, and whether the data set says that they touch in the step.
struct JudgedPair {
  MeshPair pair;
  bool touches = false;
};

/// One step of a scene.
struct PublicStep {
  std::string name;  ///< "cloth-ball 92": the scene's folder, and the number of its first frame
  Mesh mesh;
  std::vector<double> x0, x1;      ///< the positions: x y z x y z ...
  std::vector<JudgedPair> judged;  ///< in the order of the files; empty without them
};

/// The files of one step.
struct PublicStepFiles {
  std::filesystem::path scene;  ///< the folder
  std::string before, after;    ///< the frames
  std::string number;           ///< of the first one: the digits at the end of its name
  std::string label() const;    ///< as PublicStep::name
};

/// The steps of the scenes in these folders. A scene is a folder with a folder `frames`, in which each two mesh files
/// that follow each other are a step. A folder without one stands for the scenes in it.
/// @throws FileError  for a folder in which there is none
std::vector<PublicStepFiles> find_public_steps(const std::vector<std::string>& folders);

/// Reads a step. What the data set says of step N is in boxes/Nee.json and boxes/Nvf.json, lists of pairs of numbers,
/// and in mma_bool/Nee_mma_bool.json and so on, lists of booleans in the same order. The numbers are those of the
/// vertices, then of the edges in the order of their greater corners, then of their lesser ones, then of the faces.
/// @throws FileError  for a file that does not fit, or without its other half
PublicStep read_public_step(const PublicStepFiles& files);

}  // namespace touchstone::cli
