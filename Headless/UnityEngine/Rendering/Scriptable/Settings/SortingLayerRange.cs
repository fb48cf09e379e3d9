namespace UnityEngine.Rendering;

/// <summary>Sorting layers from a lower to an upper bound, both included.</summary>
public record struct SortingLayerRange
{
    public SortingLayerRange(short lowerBound, short upperBound)
    {
        this.lowerBound = lowerBound;
        this.upperBound = upperBound;
    }

    public static SortingLayerRange all => new(short.MinValue, short.MaxValue);

    public short lowerBound { get; set; }
    public short upperBound { get; set; }

    internal readonly bool Contains(int layer) => layer >= lowerBound && layer <= upperBound;
}
