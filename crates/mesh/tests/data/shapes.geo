// All four shapes: hexahedra below, wedges beside them, pyramids and tetrahedra on top. Metres.
Point(1) = {0, 0, 0}; Point(2) = {2, 0, 0}; Point(3) = {2, 2, 0}; Point(4) = {0, 2, 0};
Point(5) = {4, 0, 0}; Point(6) = {4, 2, 0}; Point(7) = {1, 1, 4};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {2, 5}; Line(6) = {5, 6}; Line(7) = {6, 3};
Transfinite Curve{1:7} = 3;
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Transfinite Surface{1}; Recombine Surface{1};
Curve Loop(2) = {5, 6, 7, -2}; Plane Surface(2) = {2}; Transfinite Surface{2};
a[] = Extrude{0, 0, 2}{ Surface{1}; Layers{2}; Recombine; };
b[] = Extrude{0, 0, 2}{ Surface{2}; Layers{2}; Recombine; };
top[] = Boundary{ Surface{a[0]}; };
For k In {0:3}
  ends[] = Boundary{ Curve{Abs(top[k])}; };
  corner[k] = (top[k] > 0) ? ends[0] : ends[1];
EndFor
For k In {0:3}
  Line(200 + k) = {corner[k], 7};
  Transfinite Curve{200 + k} = 3;
EndFor
For k In {0:3}
  n = (k + 1)%4;
  Curve Loop(300 + k) = {top[k], 200 + n, -(200 + k)};
  Plane Surface(300 + k) = {300 + k};
EndFor
Surface Loop(400) = {a[0], 300:303}; Volume(400) = {400};
Physical Volume("bricks") = {a[1]};
Physical Volume("wedges") = {b[1]};
Physical Volume("roof") = {400};
Physical Surface("ground") = {1, 2};
Physical Surface("slope") = {300:303};
Physical Surface("eaves") = {a[0]};
