// The colour of scenery: one, or tiles of two along the world's x and z axes.
#ifndef SPHFLUID_SCENERY_TILES_INCLUDED
#define SPHFLUID_SCENERY_TILES_INCLUDED

float4 _Color;
float4 _TileColor;
float _TileSize; // edge of a tile [m]; 0: no tiles

// How much of a pixel the second colour covers: a checkerboard averaged over the pixel, axis by axis (Quilez 2017, "Filtering the
// checkerboard pattern"). Far away a half.
float TileShare(float2 place)
{
    float2 width = max(fwidth(place), 1e-4);
    float2 lower = abs(frac(0.5 * (place - 0.5 * width)) - 0.5);
    float2 upper = abs(frac(0.5 * (place + 0.5 * width)) - 0.5);
    float2 sides = clamp(2.0 * (lower - upper) / width, -1.0, 1.0);
    return 0.5 - 0.5 * sides.x * sides.y;
}

float3 SceneryColour(float3 world)
{
    float share = TileShare(world.xz / max(_TileSize, 1e-3));
    return lerp(_Color.rgb, _TileColor.rgb, _TileSize > 0.0 ? share : 0.0);
}

#endif
