namespace UnityEngine.Rendering;

/// <summary>Render queues from a lower to an upper bound, both included.</summary>
public record struct RenderQueueRange
{
    public static readonly int minimumBound;
    public static readonly int maximumBound = 5000;

    public RenderQueueRange(int lowerBound, int upperBound)
    {
        this.lowerBound = lowerBound;
        this.upperBound = upperBound;
    }

    public static RenderQueueRange all => new(minimumBound, maximumBound);
    public static RenderQueueRange opaque => new(minimumBound, (int)RenderQueue.GeometryLast);
    public static RenderQueueRange transparent => new((int)RenderQueue.GeometryLast + 1, maximumBound);

    public int lowerBound { get; set; }
    public int upperBound { get; set; }

    internal readonly bool Contains(int queue) => queue >= lowerBound && queue <= upperBound;
}
