namespace SphFluid
{
    /// <summary>
    /// Tells when a value crosses a threshold, once a crossing: it has to leave a band around the threshold on the other side.
    /// </summary>
    internal struct SensorSwitch
    {
        private bool isKnown;

        /// <summary>Whether the value is above.</summary>
        public bool IsAbove { get; private set; }

        /// <summary>Forgets on which side the value was.</summary>
        public void Reset() => this = default;

        /// <summary>Takes the next value. The first only tells the side.</summary>
        /// <param name="value">The value.</param>
        /// <param name="threshold">What it crosses.</param>
        /// <param name="hysteresis">Width of the band, 0 or more.</param>
        /// <returns>1 when it rose above, -1 when it fell below, else 0.</returns>
        public int Update(float value, float threshold, float hysteresis)
        {
            float half = hysteresis > 0f ? 0.5f * hysteresis : 0f;
            bool above = !isKnown ? value > threshold : IsAbove ? value >= threshold - half : value > threshold + half;
            int crossed = !isKnown || above == IsAbove ? 0 : above ? 1 : -1;
            (isKnown, IsAbove) = (true, above);
            return crossed;
        }
    }
}
