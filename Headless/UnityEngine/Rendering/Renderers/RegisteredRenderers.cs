using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Renderers that are enabled in the running scenes.</summary>
internal static class RegisteredRenderers
{
    private static readonly List<Renderer> Renderers = [];

    public static IReadOnlyList<Renderer> All
    {
        get
        {
            Renderers.RemoveAll(r => r == null);
            return SceneTable.Previews.Count == 0 ? Renderers : Renderers.FindAll(SceneTable.IsInWorld);
        }
    }

    public static void Add(Renderer renderer) => Renderers.Add(renderer);

    public static void Remove(Renderer renderer) => Renderers.RemoveAll(r => ReferenceEquals(r, renderer));
}
