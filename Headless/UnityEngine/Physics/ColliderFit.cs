using UnityEngine;

namespace Headless.Engine;

/// <summary>A collider added to an object with a mesh takes the mesh's size, as AddComponent does in Unity.</summary>
static class ColliderFit
{
    public static Mesh? MeshOf(Component component)
    {
        MeshFilter filter = component.GetComponent<MeshFilter>();
        return filter && filter.sharedMesh ? filter.sharedMesh : null;
    }

    public static Bounds? MeshBounds(Component component) => MeshOf(component)?.bounds;
}
