// The colour of scenery: one, or tiles of two with grout between them, along the world's axes on the plane that a face lies in most.
#ifndef SPHFLUID_SCENERY_TILES_INCLUDED
#define SPHFLUID_SCENERY_TILES_INCLUDED

float4 _Color;
float4 _TileColor;
float4 _GroutColor;
float4 _FadeColor;
float _TileSize;     // edge of a tile [m]; 0: no tiles
float _Grout;        // width of the grout [m]
float _FadeDistance; // [m]; 0: no fade

// Tiles that a pixel covers a part of show their pattern, from 0.3 tiles a pixel on less and less, from 0.8 on their mean: what is left
// of a pattern that fine would shimmer.
float2 TileContrast(float2 width)
{
    return saturate(1.6 - 2.0 * width);
}

// How much of a pixel the second colour covers: a checkerboard averaged over the pixel, axis by axis (Quilez 2017, "Filtering the
// checkerboard pattern"). Far away a half.
float TileShare(float2 place, float2 width)
{
    float2 lower = abs(frac(0.5 * (place - 0.5 * width)) - 0.5);
    float2 upper = abs(frac(0.5 * (place + 0.5 * width)) - 0.5);
    float2 sides = clamp(2.0 * (lower - upper) / width, -1.0, 1.0) * TileContrast(width);
    return 0.5 - 0.5 * sides.x * sides.y;
}

// How much of a pixel lies between tiles: a part of each tile's edge on either axis, averaged over the pixel. E.g. 0.19 far away for a part
// of 0.1.
float GroutShare(float2 place, float2 width, float part)
{
    float2 lower = place - 0.5 * width + 0.5 * part;
    float2 upper = lower + width;
    float2 lines = (floor(upper) - floor(lower)) * part + min(frac(upper), part) - min(frac(lower), part);
    float2 share = lerp(part, saturate(lines / width), TileContrast(width));
    return 1.0 - (1.0 - share.x) * (1.0 - share.y);
}

float3 SceneryColour(float3 world, float3 normal)
{
    float3 facing = abs(normal);
    float2 along = facing.y >= max(facing.x, facing.z) ? world.xz : facing.x > facing.z ? world.zy : world.xy;
    float2 place = along / max(_TileSize, 1e-3);
    float2 width = max(fwidth(place), 1e-4);
    float3 tiles = lerp(_Color.rgb, _TileColor.rgb, TileShare(place, width));
    tiles = lerp(tiles, _GroutColor.rgb, GroutShare(place, width, saturate(_Grout / max(_TileSize, 1e-3))));
    return _TileSize > 0.0 ? tiles : _Color.rgb;
}

// How much of the fading colour is seen from a distance: 0 nearby, 0.63 at the set distance, 1 far beyond it, where the ground meets the
// sky.
float SceneryFade(float3 world, float3 eye)
{
    float3 away = (world - eye) / max(_FadeDistance, 1e-3);
    return _FadeDistance > 0.0 ? 1.0 - exp(-dot(away, away)) : 0.0;
}

#endif
