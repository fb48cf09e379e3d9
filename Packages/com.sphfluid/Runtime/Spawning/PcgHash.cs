namespace SphFluid
{
    /// <summary>Random numbers by place: M. Jarzynski, M. Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.</summary>
    internal static class PcgHash
    {
        /// <summary>32 bits that look random, the same for the same value.</summary>
        public static uint Hash(uint value)
        {
            uint state = unchecked(value * 747796405u + 2891336453u);
            uint word = unchecked(((state >> (int)((state >> 28) + 4)) ^ state) * 277803737u);
            return (word >> 22) ^ word;
        }
    }
}
