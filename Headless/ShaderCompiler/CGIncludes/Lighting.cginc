#ifndef LIGHTING_INCLUDED
#define LIGHTING_INCLUDED

#include "UnityCG.cginc"
#include "UnityLightingCommon.cginc"

#endif
