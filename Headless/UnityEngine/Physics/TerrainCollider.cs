using Headless.Engine;

namespace UnityEngine;

/// <summary>Queries see the terrain's box, which holds its surface: never fewer hits than Unity, sometimes more.</summary>
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
    internal override bool OverlapsSphere(Vector3 center, float radius) => (Shape.ClosestPoint(center) - center).sqrMagnitude <= radius * radius;
}
