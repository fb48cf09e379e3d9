using Headless.Engine;

namespace UnityEngine;

/// <summary>Overlap queries see the terrain's box, which holds its surface: never fewer hits than Unity, sometimes more. Rays see its triangles.</summary>
public class TerrainCollider : Collider
{
    public TerrainData terrainData { get; set; } = null!;

    PhysicsBox Shape
    {
        get
        {
            Vector3 half = 0.5f * terrainData.size;
            return PhysicsBox.Oriented(Pose.LocalToWorld.GetPosition() + half, half, Quaternion.identity);
        }
    }

    internal override bool HasShape => terrainData;
    internal override Bounds WorldBounds => HasShape ? Shape.Bounds : default;
    internal override bool OverlapsBox(in PhysicsBox box) => Shape.Intersects(box);
    internal override void MeetRay(ref PhysicsRay ray)
    {
        int cells = terrainData.heightmapResolution - 1;
        float[,] heights = terrainData.GetHeights(0, 0, cells + 1, cells + 1);
        bool[,] surface = terrainData.GetHoles(0, 0, cells, cells);
        Vector3 origin = Pose.LocalToWorld.GetPosition(), size = terrainData.size;
        Vector3 Corner(int x, int z) => origin + new Vector3(size.x * x / cells, size.y * heights[z, x], size.z * z / cells);
        for (int z = 0; z < cells; z++)
        {
            for (int x = 0; x < cells; x++)
            {
                if (!surface[z, x]) continue;
                ray.MeetTriangle(Corner(x, z), Corner(x, z + 1), Corner(x + 1, z + 1), Physics.queriesHitBackfaces);
                ray.MeetTriangle(Corner(x, z), Corner(x + 1, z + 1), Corner(x + 1, z), Physics.queriesHitBackfaces);
            }
        }
    }

    internal override bool OverlapsSphere(Vector3 center, float radius) => (Shape.ClosestPoint(center) - center).sqrMagnitude <= radius * radius;
}
