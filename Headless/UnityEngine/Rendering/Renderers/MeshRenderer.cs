namespace UnityEngine;

public class MeshRenderer : Renderer
{
    private MeshFilter? filter;

    public int subMeshStartIndex => 0;

    internal override Mesh? MeshToDraw
    {
        get
        {
            if (filter == null && !(OwnerOrNull?.TryGetComponent(out filter) ?? false))
            {
                return null;
            }

            Mesh? mesh = filter!.sharedMesh;
            return mesh != null ? mesh : null;
        }
    }
}
