// Data sets for tests, written by libhdf5.
// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

#include "support/catch.hpp"

namespace touchstone::tests {

/// Adds a data set of doubles to an open file; groups on the way are made. The type in the file may be another.
inline void add_dataset(hid_t file, const std::string& name, const std::vector<hsize_t>& extents,
                        const std::vector<double>& values, hid_t type, const std::vector<hsize_t>& chunk) {
  const hid_t links = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(links, 1);
  const hid_t plan = H5Pcreate(H5P_DATASET_CREATE);
  if (!chunk.empty()) {
    H5Pset_chunk(plan, static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(plan);
    if (H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0) H5Pset_deflate(plan, 9);
  }
  const hid_t space = H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr);
  const hid_t set = H5Dcreate2(file, name.c_str(), type, space, links, plan, H5P_DEFAULT);
  REQUIRE(set >= 0);
  if (!values.empty()) REQUIRE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
  H5Dclose(set);
  H5Sclose(space);
  H5Pclose(plan);
  H5Pclose(links);
}

}  // namespace touchstone::tests
