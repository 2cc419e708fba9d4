#pragma once

#include "scene/job.h"
#include "scene/scene.h"

namespace capcon {

/// What a job needs of a scene, derived once. It decides what is read from disk, which buffers there are, and
/// what is compiled into the kernels; what is false costs nothing. With everything kept the image is the
/// same, bit by bit.
struct Features {
  bool quadrics = false;   ///< spheres and disks: their test in every walk
  bool two_level = false;  ///< a tree of instances above the objects' trees
  bool jittered = false;   ///< image samples from the sampler, in the primary kernel
  bool shading =
      false;  ///< materials and lights: their buffers, what each pixel keeps of its surface, images
};

/// What a job (or, without one, ambient occlusion) needs of this scene. `instancing` as in RendererOptions.
Features needed_features(const Scene& scene, const Job* job, const std::string& instancing);

/// The same with nothing left out.
Features all_features(const Scene& scene, const std::string& instancing);

/// What must be read for a job. Ambient occlusion needs neither normals nor uvs nor images.
ReadOptions needed_reading(const Job& job, bool keep_everything);

/// Whether the tree is to have two levels: "flat" and "two-level" say it; "auto" builds one tree over all
/// instances while that is small or saves little, because one tree is walked faster (docs/tracer.md has the
/// figures).
bool wants_two_levels(const Scene& scene, const std::string& instancing);

/// Whether the tree's primitives are to be cut where that makes a better tree ("best"). Cutting takes as long
/// as 5 (courtyard) to 200 (nave) rays a triangle save; a renderer without a known job is there for many.
/// `keep_instances`: whether they have trees of their own.
bool wants_best_tree(const Scene& scene, bool keep_instances, const Job* job, const std::string& tree);

}  // namespace capcon
