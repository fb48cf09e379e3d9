using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Cameras that are enabled in the running scenes.</summary>
internal static class CameraList
{
    private static readonly List<Camera> Cameras = [];

    /// <summary>By depth, then by the time they were enabled.</summary>
    public static IReadOnlyList<Camera> Ordered
    {
        get
        {
            Cameras.RemoveAll(c => c == null);
            return [.. Cameras.OrderBy(c => c.depth)];
        }
    }

    public static void Add(Camera camera) => Cameras.Add(camera);

    public static void Remove(Camera camera) => Cameras.RemoveAll(c => ReferenceEquals(c, camera));
}
