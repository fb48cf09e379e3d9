using System;

namespace UnityEngine;

[Flags]
public enum MeshColliderCookingOptions
{
    None = 0,
    CookForFasterSimulation = 2,
    EnableMeshCleaning = 4,
    WeldColocatedVertices = 8,
    UseFastMidphase = 16,
}
