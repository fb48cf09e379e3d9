namespace SphFluid
{
    /// <summary>What a simulation was when it could not start or go on: the next try comes with the next change.</summary>
    internal sealed class FailedStart
    {
        private (FluidStartKey, FluidLiveKey, FluidCapacityPolicy, int)? keys;
        private int sources;

        /// <summary>It failed.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="sources">What its volumes, emitters and zones are, as <see cref="SceneParts.Sources"/>.</param>
        public void Remember(in FluidSpec spec, int sources)
        {
            keys = KeysOf(spec);
            this.sources = sources;
        }

        /// <summary>It did not fail, or is to be tried again whatever it is.</summary>
        public void Forget() => keys = null;

        /// <summary>Whether it failed and is still the same.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="sources">What its volumes, emitters and zones are, as <see cref="SceneParts.Sources"/>.</param>
        public bool IsUnchanged(in FluidSpec spec, int sources) => keys != null && keys.Value.Equals(KeysOf(spec)) &&
            this.sources == sources;

        private static (FluidStartKey, FluidLiveKey, FluidCapacityPolicy, int) KeysOf(in FluidSpec spec) =>
            (FluidStartKey.Create(spec), FluidLiveKey.AsGiven(spec), spec.CapacityPolicy, spec.Capacity);
    }
}
