using Headless.Engine;

namespace UnityEngine;

/// <summary>Queries see the mesh's oriented bounds, which hold the mesh: never fewer hits than Unity, sometimes more.</summary>
public class MeshCollider : Collider
{
    Mesh? m_Mesh;

    public Mesh sharedMesh { get => m_Mesh!; set => m_Mesh = value; }
    public bool convex { get; set; }

    public MeshColliderCookingOptions cookingOptions { get; set; } = MeshColliderCookingOptions.CookForFasterSimulation
        | MeshColliderCookingOptions.EnableMeshCleaning | MeshColliderCookingOptions.WeldColocatedVertices | MeshColliderCookingOptions.UseFastMidphase;

    PhysicsBox Shape => PhysicsBox.Transformed(m_Mesh!.bounds, Pose.LocalToWorld);

    internal override bool HasShape => m_Mesh && m_Mesh!.vertexCount > 0;
    internal override Bounds WorldBounds => HasShape ? Shape.Bounds : default;
    internal override bool OverlapsBox(in PhysicsBox box) => Shape.Intersects(box);

    internal override bool OverlapsSphere(Vector3 center, float radius)
    {
        Bounds local = m_Mesh!.bounds;
        PhysicsBox box = PhysicsBox.Oriented(Pose.LocalToWorld.MultiplyPoint3x4(local.center), Vector3.Scale(local.extents, Pose.AbsoluteScale), Pose.Rotation);
        return (box.ClosestPoint(center) - center).sqrMagnitude <= radius * radius;
    }

    internal override Vector3 ClosestPointCore(Vector3 position)
    {
        if (!HasShape) return position;
        if (!convex)
        {
            Debug.LogError("Physics.ClosestPoint can only be used with a BoxCollider, SphereCollider, CapsuleCollider and a convex MeshCollider.", this);
            return position;
        }
        return ConvexMesh.ClosestPoint(m_Mesh!.vertices, m_Mesh.triangles, Pose.LocalToWorld, position);
    }

    internal override void FitToMesh()
    {
        if (ColliderFit.MeshOf(this) is { } mesh) m_Mesh = mesh;
    }
}
