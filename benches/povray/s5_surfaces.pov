#version 3.7;
// S5 without its Julia set: torus (R 2, r .6), cone, cylinder, paraboloid on a floor, one point light.
#include "common.inc"
#declare Ylw = texture { pigment { color rgb <.9,.8,.2> } }
#declare Org = texture { pigment { color rgb <.9,.5,.1> } }
plane { y, 0 texture { White } }
torus { 2, .6 rotate 30*x translate <-2.6,2.2,-1> texture { Ylw } }
cone { <-3,0,3>, 1, <-3,2,3>, 0 texture { Red } }
cylinder { <0,0,3>,<0,2,3>, .8 texture { Green } }
// paraboloid y = 2 - (x-3)^2 - (z-3)^2 for y >= 0
intersection { quadric { <1,0,1>,<0,0,0>,<0,1,0>,-2 } plane { -y, 0 } translate <3,0,3> texture { Org } }
PointI(<3,9,8>, 300)
