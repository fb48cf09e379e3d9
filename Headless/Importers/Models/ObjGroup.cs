namespace Headless.Importers.Models;

/// <summary>The faces under one <c>g</c> name: one mesh.</summary>
public sealed record ObjGroup(string Name)
{
    public List<ObjFace> Faces { get; } = [];
}

/// <param name="Line">Of the file, for messages.</param>
public sealed record ObjFace(ObjCorner[] Corners, string Material, int Line);

/// <summary>0-based indices into the file's lists; -1 when not given.</summary>
public readonly record struct ObjCorner(int Position, int TextureCoordinate, int Normal);
