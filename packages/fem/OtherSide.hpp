#pragma once

namespace asperity::fem
{
// What lies on the other side of a fault. Friction, the solver, the coupling and the outputs
// distinguish kinds of fault by these values alone, so that a new kind is one more constant here
// (and its name in a deck, scenario/setup/conditions/FaultKind.cpp).
struct OtherSide
{
  // The map from the tangential unknowns w_t of a node to slip: slip = slip_factor w_t.
  double slip_factor = 1;
  // Number of sides, 1 or 2, that slip deforms and into which waves radiate.
  int deforming_sides = 1;
  // Whether the fault lies inside the mesh: then w_t is a part of the jump v+ - v- of its split
  // nodes (VertexTerms). Otherwise it is a boundary of the body, and w_t = v_t.
  bool is_inside = false;
  // Whether the other side moves the opposite way, so that by symmetry the displacement across the
  // fault is free and the normal stress does not change.
  bool is_mirrored = false;
  // Whether the two sides may part, of a fault inside the mesh: then the jump across is an unknown
  // that is not negative. Otherwise there is no opening.
  bool may_open = false;

  static const OtherSide rigid_foundation; // slip = v_t
  static const OtherSide mirror_image;     // slip = 2 v_t
  static const OtherSide body;             // slip = d_t = v+ - v-
};

inline constexpr OtherSide OtherSide::rigid_foundation = {1, 1, false, false};
inline constexpr OtherSide OtherSide::mirror_image = {2, 2, false, true};
inline constexpr OtherSide OtherSide::body = {1, 2, true, false};
} // namespace asperity::fem
