namespace UnityEngine.Rendering.RenderGraphModule;

/// <summary>A texture of one recording: imported, or made when the first pass that uses it runs.</summary>
internal sealed class GraphTexture
{
    private RenderTexture? made;

    public GraphTexture(in TextureDesc description, RTHandle? imported)
    {
        (Description, Handle, IsImported) = (description, imported, imported is not null);
    }

    public TextureDesc Description { get; set; }
    public bool IsImported { get; }
    public bool IsAlive { get; private set; } = true;

    /// <summary>Whether a pass has written it, so that a clear on first use is over.</summary>
    public bool IsTouched { get; set; }

    public RTHandle? Handle { get; private set; }

    /// <summary>Makes the texture that is not imported.</summary>
    public void Make()
    {
        if (Handle is not null)
        {
            return;
        }

        made = RenderTexture.GetTemporary(Description.ToDescriptor());
        (made.name, made.filterMode, made.wrapMode) = (Description.name, Description.filterMode, Description.wrapMode);
        Handle = RTHandles.Alloc(made);
    }

    public void Release()
    {
        IsAlive = false;
        if (made is not null)
        {
            RenderTexture.ReleaseTemporary(made);
            made = null;
        }
    }
}
