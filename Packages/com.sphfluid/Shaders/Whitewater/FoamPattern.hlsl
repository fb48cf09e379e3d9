// The film that flakes of foam show parts of: cells as of Worley 1996, "A cellular texture basis function", dense at their rims. It has no
// edges and does not repeat: neighbouring flakes show neighbouring cells. Two films are drawn along by the water; each starts anew
// while it is not seen (Max and Becker 1995, "Flow visualization using moving textures").
#ifndef SPHFLUID_FOAM_PATTERN
#define SPHFLUID_FOAM_PATTERN

#define FOAM_PERIOD 0.5 // s, mirrored by WhitewaterDrawing.cs
#define FILM_RIM 0.45   // width of a rim in cells
#define FILM_MEAN 0.45

// How far a film has come in its period, and the number of the period. second: 0 or 1.
float2 FilmTurn(float phase, float second)
{
    float turn = phase + 0.5 * second;
    return float2(frac(turn), floor(turn));
}

// In the plane that a normal is closest to; upwards is preferred.
float2 AlongSurface(float3 v, float3 normal)
{
    float3 steep = abs(normal) * float3(1.0, 1.5, 1.0);
    float2 side = steep.x > steep.z ? v.zy : v.xy;
    return steep.y >= max(steep.x, steep.z) ? v.xz : side;
}

// Where a point of the surface lies in the two films, in cells.
float4 FilmPlaces(float3 position, float3 velocity, float3 normal, float phase, float cell)
{
    float2 place = AlongSurface(position, normal);
    float2 way = AlongSurface(velocity, normal) * FOAM_PERIOD;
    float2 first = FilmTurn(phase, 0.0);
    float2 second = FilmTurn(phase, 1.0);
    float4 along = float4(place - way * (first.x - 0.5), place - way * (second.x - 0.5)) / cell;
    return along + float4(first.yy, second.yy) * float4(17.3, 5.1, 11.7, 23.9); // elsewhere in each period
}

// Two numbers from 0 to 1 of a cell.
float2 CellRandom(int2 cell)
{
    uint bits = (uint)cell.x * 0x9e3779b1u + (uint)cell.y * 0x85ebca77u;
    bits = (bits ^ (bits >> 15u)) * 0x2c1b3c6du;
    bits = (bits ^ (bits >> 12u)) * 0x297a2d39u;
    bits ^= bits >> 15u;
    return float2(uint2(bits, bits >> 16u) & 0xffffu) / 65536.0;
}

// 1 at the rim of a cell, 0 within: from the two nearest centres, one in each square.
float Film(float2 place)
{
    float2 corner = floor(place);
    float nearest = 8.0;
    float second = 8.0;
    for (uint k = 0u; k < 9u; k++)
    {
        float2 square = corner + float2(k % 3u, k / 3u) - 1.0;
        float2 apart = square + 0.1 + 0.8 * CellRandom((int2)square) - place;
        float squared = dot(apart, apart);
        second = min(second, max(nearest, squared));
        nearest = min(nearest, squared);
    }
    return 1.0 - smoothstep(0.0, FILM_RIM, sqrt(second) - sqrt(nearest));
}

// contrast: 0 where cells are smaller than pixels.
float FilmAt(float4 places, float phase, float contrast)
{
    float part = 1.0 - abs(2.0 * FilmTurn(phase, 0.0).x - 1.0); // the other has the rest
    float apart = part * (Film(places.xy) - FILM_MEAN) + (1.0 - part) * (Film(places.zw) - FILM_MEAN);
    return FILM_MEAN + contrast * apart * rsqrt(part * part + (1.0 - part) * (1.0 - part));
}

#endif
