// SPDX-License-Identifier: MIT
// Loading a rigged hand file (.glb, .fbx, .dae: all that assimp reads) through a rig map.
#pragma once

#include <filesystem>
#include <string>

#include "graspdb/hand/hand.h"

namespace graspdb {

// The rig map that lies beside a hand file: male.glb -> male.rig.toml. docs/hands.md explains it
// with an example. Its keys:
//   handedness       "right" or "left"
//   metres_per_unit  1 when absent
//   origin, licence  of the hand file, for the data card of databases; may be absent
//   thumb_nail       the way the nail faces at rest, three numbers in the file's coordinates
//   [bones]          for each bone_name() a list of the file's bones: the joint is the first one's
//                    origin (the palm's is the wrist, the forearm's lies nearer the elbow), and the
//                    skin of all of them follows it. Every bone that moves skin must be named.
//                    Absent may be: the fingers' metacarpals, which then begin at .3 of the way
//                    from wrist to knuckle while their skin stays with the palm; the forearm.
//   [tips]           where digits end, for each of thumb, index, middle, ring, little one of
//                    index (a joint), index_position (a point at rest), index_beyond_distal_mm. A
//                    digit that is absent ends where its last bone leaves the skin.
//   [forearm]        split_at_mm, split_width_mm: needed when no bone is the forearm. Skin beyond
//                    the wrist is then its own: half at the one, smoothly within the other.
//                    extend_mm: how much forearm is grown from the mesh's end, a cap or a loop;
//                    a loop anywhere else is refused
//   [corrections]    index_proximal_mm, ...: how far a bone's joint is moved towards its far end;
//                    index_roll_deg, ...: how far a finger's back faces the thumb's side at rest,
//                    beyond what the joints tell
//   [skin]           longest_edge_mm: longer edges are halved, on a curved surface;
//                    bind_half_bent: true for a hand that is bound with straight fingers
std::filesystem::path rig_map_beside(const std::filesystem::path& hand_file);

// Reads mesh, weights and joint positions from `hand_file`, and everything else that a hand is
// (frames, zero pose) from the joint positions and the rig map; the file's own bone axes are
// ignored. Vertices that a file repeats along seams become one. A mesh without skin moves with the
// bone that it hangs from. A left hand is mirrored into a right one. Throws Error naming the files
// and the bone or key; and for a handedness that the signs of palm_side.h do not bear out, naming
// them.
Hand load_hand(const std::filesystem::path& hand_file, const std::filesystem::path& rig_map);
Hand load_hand(const std::filesystem::path& hand_file);

// A default hand (hand_maker.h): assets/hands/NAME.glb in the data directory. That of whoever names
// none is the male one.
std::filesystem::path default_hand_file(const std::string& name = "male");

}  // namespace graspdb
