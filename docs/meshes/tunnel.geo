// A lined circular tunnel in a square block, hexahedra alone; the tunnel runs along z.
SetFactory("Built-in");
ri=8.0; ro=8.5; L=40; LZ=10; nC=8; nL=2; nR=12; nZ=4; prog=1.18;
Point(1)={0,0,0,1};
For k In {0:7}
  a=k*Pi/4;
  Point(10+k)={ri*Cos(a),ri*Sin(a),0,1};
  Point(20+k)={ro*Cos(a),ro*Sin(a),0,1};
EndFor
Point(30)={L,0,0,1};Point(31)={L,L,0,1};Point(32)={0,L,0,1};Point(33)={-L,L,0,1};
Point(34)={-L,0,0,1};Point(35)={-L,-L,0,1};Point(36)={0,-L,0,1};Point(37)={L,-L,0,1};
For k In {0:7}
  kn=(k+1)%8;
  Circle(100+k)={10+k,1,10+kn}; Circle(110+k)={20+k,1,20+kn}; Line(120+k)={30+k,30+kn};
  Line(130+k)={10+k,20+k}; Line(140+k)={20+k,30+k};
  Transfinite Curve{100+k,110+k,120+k}=nC+1; Transfinite Curve{130+k}=nL+1; Transfinite Curve{140+k}=nR+1 Using Progression prog;
EndFor
For k In {0:7}
  kn=(k+1)%8;
  Curve Loop(200+k)={130+k,110+k,-(130+kn),-(100+k)}; Plane Surface(300+k)={200+k};
  Curve Loop(210+k)={140+k,120+k,-(140+kn),-(110+k)}; Plane Surface(310+k)={210+k};
  Transfinite Surface{300+k}; Transfinite Surface{310+k}; Recombine Surface{300+k,310+k};
EndFor
lin[]={};roc[]={};inn[]={};itf[]={};zt[]={};outer[]={};
For k In {0:7}
  e[]=Extrude{0,0,LZ}{Surface{300+k};Layers{nZ};Recombine;}; lin[]+=e[1]; zt[]+=e[0]; itf[]+=e[3]; inn[]+=e[5];
  f[]=Extrude{0,0,LZ}{Surface{310+k};Layers{nZ};Recombine;}; roc[]+=f[1]; zt[]+=f[0]; outer[]+=f[3];
EndFor
Physical Volume("lining",1)={lin[]}; Physical Volume("rock",2)={roc[]};
Physical Surface("intrados",3)={inn[]}; Physical Surface("interface",4)={itf[]}; Physical Surface("outer",5)={outer[]};
Physical Surface("z0",6)={300:307,310:317}; Physical Surface("z1",7)={zt[]};
