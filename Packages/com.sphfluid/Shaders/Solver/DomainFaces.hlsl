#ifndef SPHFLUID_DOMAIN_FACES
#define SPHFLUID_DOMAIN_FACES

// Where the domain's faces are along each axis, m, far away where a face is not of the kind: no distance to one needs a further
// test then. A face is a wall, open, or one with the opposite face. Set by DomainFaces.cs.
float3 _WallsLow;
float3 _WallsHigh;
float3 _OpenLow;
float3 _OpenHigh;

#endif
