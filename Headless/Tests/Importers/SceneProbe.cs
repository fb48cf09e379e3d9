using UnityEngine;

namespace Headless.Tests.Importers;

/// <summary>A script that notes what it finds when it wakes.</summary>
public sealed class SceneProbe : MonoBehaviour
{
    public static readonly List<string> Log = [];

    public Transform? target;
    public GameObject? prefab;
    public SerializedSample? data;
    public Mesh? mesh;
    public TextAsset? text;
    public ExposedReference<Transform> exposed;

    private void Awake() => Log.Add($"{name} awake, target {(target != null ? target.name : "none")}");

    private void OnEnable() => Log.Add($"{name} enabled");
}
