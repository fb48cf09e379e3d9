using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public class DataSample : ScriptableObject
{
    public int[] curve = System.Array.Empty<int>();
    [Tooltip("How fast."), Min(0f)] public float speed = 1f;
    public Color tint = Color.white;
    public SendMessageOptions choice;
}
