using Headless.Importers.Yaml;
using UnityEngine;

namespace Headless.Importers.Serialization;

/// <summary>The engine's own value types in the form the Editor writes them. A component that is missing keeps zero.</summary>
public static class ValueReaders
{
    private static readonly Dictionary<Type, Func<YamlMap, object>> readers = new()
    {
        [typeof(Vector2)] = m => new Vector2(m.Float("x"), m.Float("y")),
        [typeof(Vector3)] = m => Vector3(m),
        [typeof(Vector4)] = m => new Vector4(m.Float("x"), m.Float("y"), m.Float("z"), m.Float("w")),
        [typeof(Quaternion)] = m => Quaternion(m),
        [typeof(Color)] = m => Color(m),
        [typeof(Color32)] = m => Color32((uint)m.Long("rgba")),
        [typeof(Vector2Int)] = m => new Vector2Int(m.Int("x"), m.Int("y")),
        [typeof(Vector3Int)] = m => new Vector3Int(m.Int("x"), m.Int("y"), m.Int("z")),
        [typeof(Rect)] = m => new Rect(m.Float("x"), m.Float("y"), m.Float("width"), m.Float("height")),
        [typeof(Bounds)] = m => new Bounds(Vector3(m.Map("m_Center")), 2 * Vector3(m.Map("m_Extent"))),
        [typeof(LayerMask)] = m => (LayerMask)Bits(m),
        [typeof(Matrix4x4)] = m => Matrix(m),
    };

    public static bool Knows(Type type) => readers.ContainsKey(type);

    public static object Read(Type type, YamlMap map) => readers[type](map);

    public static Vector3 Vector3(YamlMap? m) => m is null ? default : new Vector3(m.Float("x"), m.Float("y"), m.Float("z"));

    public static Quaternion Quaternion(YamlMap? m) => m is null ? UnityEngine.Quaternion.identity : new Quaternion(m.Float("x"), m.Float("y"), m.Float("z"), m.Float("w", 1));

    public static Color Color(YamlMap? m) => m is null ? default : new Color(m.Float("r"), m.Float("g"), m.Float("b"), m.Float("a", 1));

    /// <summary>A layer mask: <c>m_Bits: 4294967295</c> is all layers, -1.</summary>
    public static int Bits(YamlMap? m) => m is null ? 0 : unchecked((int)(uint)m.Long("m_Bits"));

    private static Color32 Color32(uint rgba) => new((byte)rgba, (byte)(rgba >> 8), (byte)(rgba >> 16), (byte)(rgba >> 24));

    private static Matrix4x4 Matrix(YamlMap map)
    {
        var matrix = new Matrix4x4();
        for (int row = 0; row < 4; row++)
            for (int column = 0; column < 4; column++)
                matrix[row, column] = map.Float($"e{row}{column}");
        return matrix;
    }
}
