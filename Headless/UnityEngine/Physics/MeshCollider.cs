using Headless.Engine;

namespace UnityEngine;

/// <summary>Overlap queries see the mesh's oriented bounds, which hold the mesh: never fewer hits than Unity, sometimes more. Rays see its triangles.</summary>
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

    internal override void MeetRay(ref PhysicsRay ray)
    {
        Vector3[] corners = m_Mesh!.vertices;
        int[] triangles = m_Mesh.triangles;
        for (int i = 0; i < corners.Length; i++) corners[i] = Pose.LocalToWorld.MultiplyPoint3x4(corners[i]);
        bool mirrored = Pose.Scale.x * Pose.Scale.y * Pose.Scale.z < 0f;
        for (int t = 0; t + 2 < triangles.Length; t += 3)
        {
            Vector3 a = corners[triangles[t]], b = corners[triangles[t + 1]], c = corners[triangles[t + 2]];
            ray.MeetTriangle(a, mirrored ? c : b, mirrored ? b : c, Physics.queriesHitBackfaces && !convex);
        }
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
