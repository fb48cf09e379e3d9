namespace UnityEngine;

public sealed class MeshFilter : Component
{
    private Mesh? meshField;
    private bool ownsMesh;

    public Mesh? sharedMesh
    {
        get => meshField;
        set => (meshField, ownsMesh) = (value, false);
    }

    /// <summary>The filter's own copy, made at the first call as in Unity.</summary>
    public Mesh? mesh
    {
        get
        {
            if (!ownsMesh)
            {
                meshField = meshField != null ? Instantiate(meshField) : new Mesh();
                meshField.name = meshField.name.Replace("(Clone)", " Instance");
                ownsMesh = true;
            }

            return meshField;
        }
        set => (meshField, ownsMesh) = (value, true);
    }
}
