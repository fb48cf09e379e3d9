namespace SphFluid
{
    /// <summary>A component beside a simulation that says how much detail its liquid is worth.</summary>
    internal interface IFluidDetailSource
    {
        /// <summary>Whether it is enabled.</summary>
        bool IsOn { get; }

        /// <summary>What it says now.</summary>
        FluidDetail Detail { get; }

        /// <summary>That and why, in a few words: "detail 2 of 3: 48 m from Main Camera".</summary>
        string Describe();
    }
}
