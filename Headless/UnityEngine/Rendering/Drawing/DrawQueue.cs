using System.Collections.Generic;

namespace Headless.Engine;

/// <summary>Draws asked for by Graphics.Render... and Graphics.Draw... for the cameras of the current frame.</summary>
internal static class DrawQueue
{
    private static readonly List<DrawRequest> Queue = [];

    public static IReadOnlyList<DrawRequest> Requests => Queue;

    public static void Add(DrawRequest request) => Queue.Add(request);

    public static void Clear() => Queue.Clear();
}
