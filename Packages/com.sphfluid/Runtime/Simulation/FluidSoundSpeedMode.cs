namespace SphFluid
{
    /// <summary>Where a running liquid's speed of sound comes from. Standard method only; others keep that of the start.</summary>
    public enum FluidSoundSpeedMode
    {
        /// <summary>By rule from where the liquid starts; it stays.</summary>
        FixedByRule = 0,

        /// <summary>
        /// By the same rule from where the liquid is: lower once it has come down and is calm, which saves steps, and back in time when it
        /// is lifted or stirred; never above the rule of the start. Not with a fixed time step.
        /// </summary>
        FollowsLiquid = 1,
    }
}
