using System;
using Headless.Engine;

namespace UnityEngine.Rendering;

public struct RenderTargetIdentifier : IEquatable<RenderTargetIdentifier>
{
    public const int AllDepthSlices = -1;

    public RenderTargetIdentifier(BuiltinRenderTextureType type)
        : this(type, 0)
    {
    }

    public RenderTargetIdentifier(BuiltinRenderTextureType type, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
    {
        Builtin = type;
        NameId = -1;
        MipLevel = mipLevel;
        Slice = cubeFace == CubemapFace.Unknown ? depthSlice : (int)cubeFace;
    }

    public RenderTargetIdentifier(string name)
        : this(ShaderNames.Id(name), 0)
    {
    }

    public RenderTargetIdentifier(string name, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
        : this(ShaderNames.Id(name), mipLevel, cubeFace, depthSlice)
    {
    }

    public RenderTargetIdentifier(int nameID)
        : this(nameID, 0)
    {
    }

    public RenderTargetIdentifier(int nameID, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
        : this(BuiltinRenderTextureType.PropertyName, mipLevel, cubeFace, depthSlice) => NameId = nameID;

    public RenderTargetIdentifier(Texture tex)
        : this(tex, 0)
    {
    }

    public RenderTargetIdentifier(Texture tex, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
        : this(
            tex is null ? BuiltinRenderTextureType.None : tex is RenderTexture ? BuiltinRenderTextureType.RenderTexture : BuiltinRenderTextureType.BindableTexture,
            mipLevel, cubeFace, depthSlice) => Texture = tex;

    public RenderTargetIdentifier(RenderBuffer buf, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
        : this(buf.Texture is null ? BuiltinRenderTextureType.CameraTarget : BuiltinRenderTextureType.BufferPtr, mipLevel, cubeFace, depthSlice) =>
        Texture = buf.Texture;

    public RenderTargetIdentifier(RenderTargetIdentifier renderTargetIdentifier, int mipLevel, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
        : this(renderTargetIdentifier.Builtin, mipLevel, cubeFace, depthSlice)
    {
        NameId = renderTargetIdentifier.NameId;
        Texture = renderTargetIdentifier.Texture;
    }

    internal BuiltinRenderTextureType Builtin { get; }
    internal int NameId { get; }
    internal Texture? Texture { get; }
    internal int MipLevel { get; }
    internal int Slice { get; }

    public static implicit operator RenderTargetIdentifier(BuiltinRenderTextureType type) => new(type);

    public static implicit operator RenderTargetIdentifier(string name) => new(name);

    public static implicit operator RenderTargetIdentifier(int nameID) => new(nameID);

    public static implicit operator RenderTargetIdentifier(Texture tex) => new(tex);

    public static implicit operator RenderTargetIdentifier(RenderBuffer buf) => new(buf);

    public static bool operator ==(RenderTargetIdentifier lhs, RenderTargetIdentifier rhs) => lhs.Equals(rhs);

    public static bool operator !=(RenderTargetIdentifier lhs, RenderTargetIdentifier rhs) => !lhs.Equals(rhs);

    public bool Equals(RenderTargetIdentifier rhs) => Builtin == rhs.Builtin && NameId == rhs.NameId
        && ReferenceEquals(Texture, rhs.Texture) && MipLevel == rhs.MipLevel && Slice == rhs.Slice;

    public override bool Equals(object? obj) => obj is RenderTargetIdentifier other && Equals(other);

    public override int GetHashCode() => HashCode.Combine(Builtin, NameId, Texture, MipLevel, Slice);

    public override string ToString() =>
        $"Type {Builtin} NameID {(Builtin == BuiltinRenderTextureType.PropertyName ? ShaderNames.Name(NameId) : "-1")} MipLevel {MipLevel} DepthSlice {Slice}";
}
