// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The choice of a format of meshes; see mesh_reader.h.

#include "mesh_reader.h"

#include "obj_reader.h"
#include "off_reader.h"
#include "ply_reader.h"
#include "stl_reader.h"

namespace near_pairs {

std::unique_ptr<Mesh_reader> make_mesh_reader(const std::string& format, const Input& input,
                                              const Read_options& options)
{
  if(format == "off")
    return std::make_unique<Off_reader>(input, options);
  if(format == "ply")
    return std::make_unique<Ply_reader>(input, options);
  if(format == "obj")
    return std::make_unique<Obj_reader>(input, options);
  if(format == "stl")
    return std::make_unique<Stl_reader>(input, options);
  return nullptr;
}

} // namespace near_pairs
