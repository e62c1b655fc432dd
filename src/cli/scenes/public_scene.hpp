// Scenes of the public time-of-impact data set (Belgrod et al. 2023), as its files come.
// SPDX-License-Identifier: MIT
#pragma once

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
  std::vector<double> x0, x1;  ///< the positions: x y z x y z ...
  bool has_truth = false;
  std::vector<JudgedPair> judged;  ///< in the order of the files; empty without a truth
};

/// The files of one step.
struct PublicStepFiles {
  struct Truth {
    std::string pairs, verdicts;
  };

  std::string name;           ///< as PublicStep::name
  std::string before, after;  ///< the frames
  Truth edges, faces;         ///< about pairs of edges, and of a vertex and a face; no names where there is none
  std::vector<std::string> all() const;
};

/// The steps of the scenes in these folders. A scene is a folder with a folder `frames`, in which each two mesh files
/// that follow each other are a step. Their names end in numbers, and the first one's is the step's. A folder without
/// `frames` stands for the scenes in it. Names that begin with a dot are skipped.
///
/// What the data set says of step N is in boxes/Nee.json and boxes/Nvf.json, lists of pairs of numbers, and in
/// mma_bool/Nee_mma_bool.json and mma_bool/Nvf_mma_bool.json, lists of booleans in the same order. The numbers are
/// those of the vertices, then of the edges in the order of their greater corners and then of their lesser ones, then
/// of the faces.
/// @throws FileError  for a folder in which there is no scene, and for a file in `boxes` or `mma_bool` that belongs to
/// no step, or has not its other half
std::vector<PublicStepFiles> find_public_steps(const std::vector<std::string>& folders);

/// Reads a step. @throws FileError  for a file that cannot be read or does not fit
PublicStep read_public_step(const PublicStepFiles& files);

}  // namespace touchstone::cli
