// Meridian section of a rubber pad of 3 mm with a stiffer skin of 0.3 mm on it, x for r and y for z, in mm.
// gmsh -2 pad-and-skin.geo
r_contact = 1.5;  // the indenter touches somewhere inside
r_side = 8;
z_pad = 3;        // from the base up
z_skin = 3.3;     // the surface
n_rings = 36;

Point(1) = {0, 0, 0};
Point(2) = {r_contact, 0, 0};
Point(3) = {r_side, 0, 0};
Point(4) = {0, z_pad, 0};
Point(5) = {r_contact, z_pad, 0};
Point(6) = {r_side, z_pad, 0};
Point(7) = {0, z_skin, 0};
Point(8) = {r_contact, z_skin, 0};
Point(9) = {r_side, z_skin, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {7, 8};
Line(6) = {8, 9};
Line(7) = {1, 4};
Line(8) = {2, 5};
Line(9) = {3, 6};
Line(10) = {4, 7};
Line(11) = {5, 8};
Line(12) = {6, 9};

Curve Loop(1) = {1, 8, -3, -7};
Curve Loop(2) = {2, 9, -4, -8};
Curve Loop(3) = {3, 11, -5, -10};
Curve Loop(4) = {4, 12, -6, -11};
For i In {1 : 4}
  Plane Surface(i) = {i};
EndFor

// Quadrilaterals in rows and columns, finest below the contact.
Transfinite Curve {1, 3, 5} = n_rings + 1;
Transfinite Curve {2, 4, 6} = 19 Using Progression 1.18;
Transfinite Curve {-7, -8, -9} = 15 Using Progression 1.15;
Transfinite Curve {10, 11, 12} = 8;
Transfinite Surface {1 : 4};
Recombine Surface {1 : 4};

Physical Curve("contact") = {5};
Physical Curve("axis") = {7, 10};
Physical Curve("base") = {1, 2};
Physical Curve("side") = {9, 12};
Physical Surface("pad") = {1, 2};
Physical Surface("skin") = {3, 4};
