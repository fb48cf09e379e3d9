using Headless.Engine;

namespace UnityEngine;

public sealed partial class MaterialPropertyBlock
{
    public bool isEmpty => Sheet.IsEmpty;

    internal PropertySheet Sheet { get; } = new();

    public void Clear() => Sheet.Clear();
}
