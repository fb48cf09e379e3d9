using UnityEngine;
using UnityEngine.Serialization;

namespace Headless.Tests.Importers;

/// <summary>Every kind of field that Unity stores, and some that it does not.</summary>
public sealed class SerializedSample : ScriptableObject, ISerializationCallbackReceiver
{
    public enum Kind : byte { None, First, Second }

    public interface IShape { }

    [Serializable]
    public sealed class Circle : IShape { public float radius; }

    [Serializable]
    public struct Range { public float low; public float high; }

    [Serializable]
    public sealed class Section { public string title = "untitled"; public int[]? ids; public Range range; }

    public const int Constant = 1;
    public static int Static = 2;
    public readonly int ReadOnly = 3;
    [NonSerialized] public int notSerialized = 4;
    public Dictionary<string, int> dictionary = new() { ["kept"] = 1 };

    public bool flag;
    public int number = 7;
    public long big;
    public float real;
    public string text = "default";
    public Kind kind;
    public Kind[]? kinds;
    public Vector3 vector;
    public Quaternion rotation;
    public Color colour;
    public Bounds bounds;
    public Rect rect;
    public LayerMask mask;
    public int[]? packed;
    public bool[]? packedFlags;
    public List<Kind>? packedKinds;
    public List<string>? texts;
    public List<float>? reals;
    public Section section = new();
    public List<Section>? sections;
    public SerializedSample? reference;
    public List<ScriptableObject>? references;
    public ExposedReference<SerializedSample> exposed;
    [SerializeReference] public IShape? shape;
    [SerializeReference] public List<IShape?>? shapes;
    [SerializeField] private int hidden;
    [SerializeField, FormerlySerializedAs("oldName")] private int renamed;
    [field: SerializeField] public float Viscosity { get; private set; }
    private int plainPrivate = 5;

    public int Hidden => hidden;
    public int Renamed => renamed;
    public int PlainPrivate => plainPrivate;
    public int Callbacks { get; private set; }

    public void OnBeforeSerialize() { }

    public void OnAfterDeserialize() => Callbacks++;
}
