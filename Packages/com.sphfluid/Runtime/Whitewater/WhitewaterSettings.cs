namespace SphFluid
{
    /// <summary>What a liquid's whitewater is to be.</summary>
    internal readonly struct WhitewaterSettings
    {
        /// <param name="capacity">Most pieces at once, 1 or more.</param>
        /// <param name="amount">Times as many births as by default, 0 or more.</param>
        /// <param name="foamLife">How long foam lies on still water, at most [s].</param>
        public WhitewaterSettings(int capacity, float amount, float foamLife)
        {
            Capacity = capacity;
            Amount = amount;
            FoamLife = foamLife;
        }

        /// <summary>Most pieces at once.</summary>
        public int Capacity { get; }

        /// <summary>Times as many births as by default.</summary>
        public float Amount { get; }

        /// <summary>How long foam lies on still water, at most [s].</summary>
        public float FoamLife { get; }
    }
}
