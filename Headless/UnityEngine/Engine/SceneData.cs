using System.Collections.Generic;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Headless.Engine;

/// <summary>A loaded scene: its root objects in order.</summary>
sealed class SceneData(int handle, string name, string path)
{
    public Scene Scene { get; } = new(handle);
    public int Handle { get; } = handle;
    public string Name { get; set; } = name;
    public string Path { get; set; } = path;
    public int BuildIndex { get; set; } = -1;
    public bool IsLoaded { get; set; }

    /// <summary>Apart from the loaded scenes: not listed, not searched, not drawn, with physics of its own.</summary>
    public bool IsPreview { get; init; }

    public List<GameObject> Roots { get; } = new();

    public void AddRoot(GameObject root) => Roots.Add(root);

    public void RemoveRoot(GameObject root)
    {
        int index = Roots.FindIndex(r => ReferenceEquals(r, root));
        if (index >= 0) Roots.RemoveAt(index);
    }
}
