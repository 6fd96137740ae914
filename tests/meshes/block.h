#pragma once

#include "meshes/mesh.h"

namespace fretval::meshes {

/// A good mesh simple enough to break by hand: the square [0, 2] x [-2, 0] of 2 x 2 cells of size 1.
///
///     6 --- 7 --- 8    z = 0: contact from 6 to 7, free from 7 to 8
///     |  2  |  3  |
///     3 --- 4 --- 5    axis on the left, far on the right and below
///     |  0  |  1  |
///     0 --- 1 --- 2
///
/// Edges 0, 1: axis; 2: contact; 3: free; 4, 5: far on the right; 6, 7: far below.
inline Mesh block() {
  using B = Boundary;
  return {{{0, -2}, {1, -2}, {2, -2}, {0, -1}, {1, -1}, {2, -1}, {0, 0}, {1, 0}, {2, 0}},
          {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}},
          {{{0, 3}, B::axis},
           {{3, 6}, B::axis},
           {{6, 7}, B::contact},
           {{7, 8}, B::free},
           {{8, 5}, B::far},
           {{5, 2}, B::far},
           {{0, 1}, B::far},
           {{1, 2}, B::far}}};
}

}  // namespace fretval::meshes
