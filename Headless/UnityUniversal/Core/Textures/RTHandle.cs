namespace UnityEngine.Rendering;

/// <summary>A render texture, a texture of someone else's or an identifier, under one name.</summary>
public class RTHandle
{
    private readonly bool isOwner;
    private RenderTexture? target;
    private Texture? external;

    internal RTHandle(RenderTexture? target, Texture? external, RenderTargetIdentifier id, string name, bool isOwner)
    {
        (this.target, this.external, nameID, this.name, this.isOwner) = (target, external, id, name, isOwner);
    }

    public RenderTexture? rt => target;
    public Texture? externalTexture => external;
    public RenderTargetIdentifier nameID { get; private set; }
    public string name { get; }
    public Vector2 scaleFactor => Vector2.one;
    public bool useScaling => false;
    public bool isMSAAEnabled => target != null && target.antiAliasing > 1;

    public static implicit operator RenderTargetIdentifier(RTHandle? handle) => handle is null ? default : handle.nameID;

    public static implicit operator Texture?(RTHandle? handle) => handle is null ? null : handle.target != null ? handle.target : handle.external;

    public static implicit operator RenderTexture?(RTHandle? handle) => handle?.target;

    public Vector2Int GetScaledSize() => target != null ? new Vector2Int(target.width, target.height) : Vector2Int.zero;

    public void Release()
    {
        if (isOwner && target != null)
        {
            target.Release();
            Object.DestroyImmediate(target);
        }

        (target, external, nameID) = (null, null, BuiltinRenderTextureType.None);
    }

    /// <summary>Points the handle at another target.</summary>
    internal void Show(RenderTexture? texture, RenderTargetIdentifier id) => (target, nameID) = (texture, id);
}
