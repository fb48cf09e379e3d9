using System;
using System.Collections.Generic;
using Headless.Engine;

namespace UnityEngine.SceneManagement;

[Serializable]
public struct Scene
{
    [SerializeField] int m_Handle;

    internal Scene(int handle) => m_Handle = handle;

    public int handle => m_Handle;
    public bool IsValid() => SceneTable.Find(m_Handle) is not null;
    public string path => SceneTable.Find(m_Handle)?.Path ?? "";
    public string name { get => SceneTable.Find(m_Handle)?.Name ?? ""; set { if (SceneTable.Find(m_Handle) is { } data) data.Name = value; } }
    public bool isLoaded => SceneTable.Find(m_Handle)?.IsLoaded ?? false;
    public int buildIndex => SceneTable.Find(m_Handle)?.BuildIndex ?? -1;
    public bool isDirty => false;
    public int rootCount => SceneTable.Find(m_Handle)?.Roots.Count ?? 0;

    public GameObject[] GetRootGameObjects() => SceneTable.Require(this).Roots.ToArray();

    public void GetRootGameObjects(List<GameObject> rootGameObjects)
    {
        SceneData data = SceneTable.Require(this);
        rootGameObjects.Clear();
        rootGameObjects.AddRange(data.Roots);
    }

    public static bool operator ==(Scene lhs, Scene rhs) => lhs.m_Handle == rhs.m_Handle;
    public static bool operator !=(Scene lhs, Scene rhs) => lhs.m_Handle != rhs.m_Handle;
    public override bool Equals(object? other) => other is Scene scene && scene.m_Handle == m_Handle;
    public override int GetHashCode() => m_Handle;
}
