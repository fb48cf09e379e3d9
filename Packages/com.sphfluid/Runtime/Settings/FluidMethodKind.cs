namespace SphFluid
{
    /// <summary>Methods to compute the liquid's motion.</summary>
    public enum FluidMethodKind
    {
        /// <summary>Figueroa's thesis (2012), corrected: Müller's kernels, bitonic sort, one time step after another.</summary>
        Thesis = 0,

        /// <summary>
        /// The thesis's text as printed, as far as it can run (<see cref="ThesisSwitches.Printed"/>): for comparison, not for use.
        /// </summary>
        ThesisPrinted = 1,

        /// <summary>
        /// Weakly compressible SPH with one kernel, walls that carry density, and a counting sort: faster, more accurate, the default.
        /// </summary>
        Standard = 2,

        /// <summary>
        /// Small-step XPBD: a fixed number of equal steps a frame at any speed. Never explodes, keeps real time, and is the softer the
        /// longer its steps are.
        /// </summary>
        Robust = 3,

        /// <summary>
        /// No method but a choice among them at the start: the most faithful one whose steps fit the frame budget of the simulation, by
        /// what they cost on this device. <see cref="FluidSimulation.ActiveMethod"/> is the one picked. A solver takes only a picked one.
        /// </summary>
        Automatic = 4,
    }
}
