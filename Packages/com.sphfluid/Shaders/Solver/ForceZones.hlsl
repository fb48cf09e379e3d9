#ifndef SPHFLUID_FORCE_ZONES
#define SPHFLUID_FORCE_ZONES

// Accelerations in parts of the domain. A kernel that includes this file declares the keyword FLUID_ZONES.
#if defined(FLUID_ZONES)

// As Runtime/Solver/ForceZone.cs; all in simulation space.
struct ForceZone
{
    float4 RowX, RowY, RowZ; // simulation space to the zone's axes, rigid
    float4 Core;             // half extents of a box, and the radius that rounds it [m]
    float4 Uniform;          // acceleration [m/s^2], and the number of zones
    float4 Centre;           // and the acceleration towards it
    float4 Axis;             // unit vector, and the acceleration around it
    float4 Wind;             // velocity [m/s], and the rate of drag towards it [1/s]
    float4 Eddies;           // largest acceleration along an axis, wavenumber [1/m], phase, and the edge of this zone [m]; 0: as all
};

StructuredBuffer<ForceZone> _Zones;
float _ZoneEdge; // m, over which a zone comes to its full strength

// 0 outside to 1 at the edge's depth: a step in force would make sound.
float ZoneWeight(ForceZone zone, float3 position)
{
    const float4 at = float4(position, 1.0);
    const float3 beyond = abs(float3(dot(zone.RowX, at), dot(zone.RowY, at), dot(zone.RowZ, at))) - zone.Core.xyz;
    const float distance = length(max(beyond, 0.0)) + min(max(beyond.x, max(beyond.y, beyond.z)), 0.0);
    return smoothstep(0.0, zone.Eddies.w > 0.0 ? zone.Eddies.w : _ZoneEdge, zone.Core.w - distance);
}

// Eddies without a source, whose streamlines are chaotic: the ABC flow (V. I. Arnold 1965; Dombre et al., J. Fluid Mech. 167, 1986) with
// equal coefficients, and phases that run apart.
float3 EddyAcceleration(float4 eddies, float3 position)
{
    const float3 p = eddies.y * position + eddies.z * float3(1.0, 1.31, 1.73);
    return 0.5 * eddies.x * (sin(p.zxy) + cos(p.yzx));
}

// Drag is taken at the kick's end, so that no rate is too fast: (v' - v) / kick = -k (v' - w).
float3 ZoneAcceleration(float3 position, float3 velocity, float kick)
{
    float3 sum = 0.0;
    const uint count = (uint)_Zones[0].Uniform.w; // a number in the buffer: a loop that ends by numbers alone costs more
    for (uint i = 0u; i < count; i++)
    {
        const ForceZone zone = _Zones[i];
        const float3 inward = zone.Centre.xyz - position;
        const float3 around = cross(inward, zone.Axis.xyz); // axis x (position - centre)
        const float weight = ZoneWeight(zone, position);
        const float rate = weight * zone.Wind.w;
        const float3 force = zone.Uniform.xyz + zone.Centre.w * inward / max(length(inward), _ZoneEdge) +
            zone.Axis.w * around / max(length(around), _ZoneEdge) + EddyAcceleration(zone.Eddies, position);
        sum += weight * force - rate / (1.0 + rate * kick) * (velocity - zone.Wind.xyz);
    }
    return sum;
}

#endif

#endif
