namespace SphFluid.Tests
{
    /// <summary>Statuses of sparse surfaces as the GPU would count them.</summary>
    internal static class SurfaceStatuses
    {
        public static SurfaceStatus Of(uint blocks, bool complete, uint openFaces = 0, uint nonFinite = 0)
        {
            var counters = new uint[SurfaceCounters.Slots];
            counters[SurfaceCounters.BlocksRequested] = blocks;
            counters[SurfaceCounters.Complete] = complete ? 1u : 0u;
            counters[SurfaceCounters.OpenFaces] = openFaces;
            counters[SurfaceCounters.NonFinite] = nonFinite;
            return new SurfaceStatus(counters);
        }
    }
}
