// The built-in body: a mannequin as a smooth union of tapered limbs, posed by skinning.
//
// About 1.70 m tall, standing on y = 0, y up, facing +z, the wearer's left along +x.  The T-pose is the zero surface of
// mannequinDistance(); the other poses turn its arms at collar bone, shoulder and elbow by turns that fade into the
// trunk (fading_turn.h).
#pragma once

#include <string>
#include <vector>

#include "collision/body/body_size.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Names of the poses: "t" arms straight out, "a" half lowered, "up" raised, "front" stretched forward.
const std::vector<std::string>& mannequinPoses();

/// Makes the body in one pose; all poses have the same triangles.  Throws InputError naming an unknown pose.
TriangleMesh mannequin(const std::string& pose, const BodyMeasures& measures = {});

}  // namespace ease
