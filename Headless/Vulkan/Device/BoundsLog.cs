using Headless.Shaders;

namespace Headless.Vulkan;

/// <summary>What shaders with bounds checks wrote down: see <see cref="BoundsCheck"/>.</summary>
internal sealed class BoundsLog
{
    private const int MaxSites = 1 << 17;
    private const int Words = BoundsCheck.WordsPerSite;

    private readonly Dictionary<BoundsSite, uint> numbers = [];
    private readonly List<BoundsSite> sites = [];

    public BoundsLog(DeviceContext context, SubmissionRing ring) =>
        Buffer = new GpuBuffer(context, ring, (MaxSites + 1L) * Words * sizeof(uint), BufferUse.Storage, BoundsCheck.LogName);

    public GpuBuffer Buffer { get; }

    /// <summary>Bytes that the sites so far can write.</summary>
    public int Used => (sites.Count + 1) * Words * sizeof(uint);

    /// <summary>Counted from 1; equal places share a number.</summary>
    public uint Register(BoundsSite site)
    {
        if (!numbers.TryGetValue(site, out uint number))
        {
            if (sites.Count == MaxSites)
            {
                throw new GpuException($"More than {MaxSites} indexed variables are checked at once; run fewer shaders in one process.");
            }

            sites.Add(site);
            numbers[site] = number = (uint)sites.Count;
        }

        return number;
    }

    public IReadOnlyList<string> Describe(ReadOnlySpan<uint> words)
    {
        List<string> lines = [];
        for (int i = 0; i < sites.Count; i++)
        {
            ReadOnlySpan<uint> entry = words.Slice((i + 1) * Words, Words);
            if (entry[0] > 0)
            {
                lines.Add(
                    $"Out of bounds in '{sites[i].Shader}': element {(int)entry[1]} of '{sites[i].Variable}', which has {entry[2]} " +
                    $"({entry[0]} threads; index and length are those of one)");
            }
        }

        return lines;
    }
}
