#ifndef SPHFLUID_WALL_VELOCITIES
#define SPHFLUID_WALL_VELOCITIES

// Velocities of the domain's faces, each within its plane, m/s: DomainBindings.SetWallVelocities.
float3 _WallLowX;
float3 _WallLowY;
float3 _WallLowZ;
float3 _WallHighX;
float3 _WallHighY;
float3 _WallHighZ;

// What the faces drag along, by how fast each takes its speed over (1/s, by axis).
float3 WallDrive(float3 rateLow, float3 rateHigh)
{
    return rateLow.x * _WallLowX + rateHigh.x * _WallHighX + rateLow.y * _WallLowY + rateHigh.y * _WallHighY
        + rateLow.z * _WallLowZ + rateHigh.z * _WallHighZ;
}

#endif
