// A circular hole in a square block: a slice of 200 m by 200 m, 1 m thick along y, with the hole's axis along y.
// Metres; z points up, the hole's centre is the origin. Makes hole.msh (Gmsh 4):
//
//     gmsh -3 hole.geo -o hole.msh -format msh41
//
// All surfaces are transfinite and recombined, so that the slice is made of hexahedra alone.

a = 5;         // radius of the hole
half = 100;    // half the side of the block
round = 12;    // elements along a quarter of the wall
rings = 34;    // elements from the wall to the sides,
growth = 1.12; // each this much longer than the one before it
inner = 6;     // elements from the square in the hole's middle to the wall
core = 2.6;    // half a diagonal of that square

// Corners at 45 degrees: of the square, on the wall, of the block.
For k In {0:3}
  c = Cos(Pi/4 + k*Pi/2); s = Sin(Pi/4 + k*Pi/2);
  Point(1 + k) = {core*c, 0, core*s};
  Point(11 + k) = {a*c, 0, a*s};
  Point(21 + k) = {half*Sqrt(2)*c, 0, half*Sqrt(2)*s};
EndFor
Point(10) = {0, 0, 0};
For k In {0:3}
  n = (k + 1)%4;
  Line(1 + k) = {1 + k, 1 + n};
  Circle(11 + k) = {11 + k, 10, 11 + n};
  Line(21 + k) = {21 + k, 21 + n};
  Line(31 + k) = {1 + k, 11 + k};
  Line(41 + k) = {11 + k, 21 + k};
EndFor
Transfinite Curve{1:4, 11:14, 21:24} = round + 1;
Transfinite Curve{31:34} = inner + 1;
Transfinite Curve{41:44} = rings + 1 Using Progression growth;

Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
For k In {0:3}
  n = (k + 1)%4;
  Curve Loop(11 + k) = {1 + k, 31 + n, -(11 + k), -(31 + k)}; Plane Surface(11 + k) = {11 + k};
  Curve Loop(21 + k) = {11 + k, 41 + n, -(21 + k), -(41 + k)}; Plane Surface(21 + k) = {21 + k};
EndFor
Transfinite Surface{1, 11:14, 21:24};
Recombine Surface{1, 11:14, 21:24};

For k In {0:3}
  hole[] = Extrude{0, 1, 0}{ Surface{11 + k}; Layers{1}; Recombine; };
  ring[] = Extrude{0, 1, 0}{ Surface{21 + k}; Layers{1}; Recombine; };
  inside[k] = hole[1]; outside[k] = ring[1];
EndFor
middle[] = Extrude{0, 1, 0}{ Surface{1}; Layers{1}; Recombine; };

Physical Volume("core") = {inside[], middle[1]};
Physical Volume("rock") = {outside[]};
