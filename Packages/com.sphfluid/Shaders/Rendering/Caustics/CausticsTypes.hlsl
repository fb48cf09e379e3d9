// What CausticsDrawing.cs hands to both stages.
#ifndef SPHFLUID_CAUSTICS_TYPES_INCLUDED
#define SPHFLUID_CAUSTICS_TYPES_INCLUDED

#include "../WaterRefraction.hlsl"

float4 _CausticsRows[2];  // world position to texels of the map
float4 _CausticsStrength; // x: 0 to 1; y: texels along a side of the map

#endif
