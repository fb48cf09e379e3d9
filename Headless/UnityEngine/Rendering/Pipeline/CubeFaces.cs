using UnityEngine;

namespace Headless.Engine;

/// <summary>The directions of a cubemap's faces.</summary>
internal static class CubeFaces
{
    public const int Count = 6;

    // Forward and up of the six faces in Direct3D's order: the first row of a face lies in the direction of its up.
    private static readonly (Vector3 Forward, Vector3 Up)[] Faces =
    [
        (Vector3.right, Vector3.up), (Vector3.left, Vector3.up),
        (Vector3.up, Vector3.back), (Vector3.down, Vector3.forward),
        (Vector3.forward, Vector3.up), (Vector3.back, Vector3.up),
    ];

    /// <summary>From the world's axes to right, up and forward of a face.</summary>
    public static Matrix4x4 ToFace(int face) =>
        Matrix4x4.Rotate(Quaternion.Inverse(Quaternion.LookRotation(Faces[face].Forward, Faces[face].Up)));
}
