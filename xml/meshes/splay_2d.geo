// The subduction zone of subduction_2d.geo with a splay, which branches off the megathrust at
// `splay_depth` and reaches the surface with `splay_dip`. Where they meet, the splay ends: its last
// node is a tip, and the megathrust goes on as if it were not there.
//
//   asperity-mesh convert splay_2d.geo splay_2d.h5 --set splay_depth=12e3
//
// All constants of subduction_2d.geo are there.

DefineConstant[splay = 1];
Include "subduction_2d.geo";
