// Lined circular tunnel in a square block: hexahedra, one layer of lining, two slices. Metres.
ri = 4; ro = 4.5; half = 16; long = 5;
Point(1) = {0, 0, 0};
For k In {0:3}
  a = (2*k + 1)*Pi/4;
  Point(10 + k) = {ri*Cos(a), ri*Sin(a), 0};
  Point(20 + k) = {ro*Cos(a), ro*Sin(a), 0};
  Point(30 + k) = {Sqrt(2)*half*Cos(a), Sqrt(2)*half*Sin(a), 0};
EndFor
For k In {0:3}
  n = (k + 1)%4;
  Circle(100 + k) = {10 + k, 1, 10 + n};
  Circle(110 + k) = {20 + k, 1, 20 + n};
  Line(120 + k) = {30 + k, 30 + n};
  Line(130 + k) = {10 + k, 20 + k};
  Line(140 + k) = {20 + k, 30 + k};
  Transfinite Curve{100 + k, 110 + k, 120 + k} = 5;
  Transfinite Curve{130 + k} = 2;
  Transfinite Curve{140 + k} = 5 Using Progression 1.3;
EndFor
For k In {0:3}
  n = (k + 1)%4;
  Curve Loop(200 + k) = {130 + k, 110 + k, -(130 + n), -(100 + k)};
  Curve Loop(210 + k) = {140 + k, 120 + k, -(140 + n), -(110 + k)};
  Plane Surface(300 + k) = {200 + k};
  Plane Surface(310 + k) = {210 + k};
  Transfinite Surface{300 + k, 310 + k};
  Recombine Surface{300 + k, 310 + k};
EndFor
lining[] = {}; rock[] = {}; intrados[] = {}; interface[] = {};
For k In {0:3}
  e[] = Extrude{0, 0, long}{ Surface{300 + k}; Layers{2}; Recombine; };
  lining[] += e[1]; interface[] += e[3]; intrados[] += e[5];
  f[] = Extrude{0, 0, long}{ Surface{310 + k}; Layers{2}; Recombine; };
  rock[] += f[1];
EndFor
Physical Volume("lining") = {lining[]};
Physical Volume("rock mass") = {rock[]};
Physical Volume("everything") = {lining[], rock[]};
Physical Surface("intrados") = {intrados[]};
Physical Surface("interface") = {interface[]};
Physical Surface(77) = {300:303};
Physical Point("corner") = {30};
