using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>All cases, in the order of the chart; the gates last.</summary>
    public static class CaseCatalogue
    {
        /// <summary>All cases.</summary>
        public static IReadOnlyList<ValidationCase> All { get; } = new ValidationCase[]
        {
            new EllipsoidCase(),
            new HydrostaticCase(),
            new StandingWaveCase(),
            new AcceleratedTankCase(),
            new PaddleCase(),
            new HeaveCase(),
            new PoiseuilleCase(),
            new CouetteCase(),
            new DamBreakCase(),
            new MarinCase(),
            new DropsCase(),
            new JetCase(),
            new WallImpactCase(),
            new CapillaryDropCase(),
            new FreeFallCase(),
            new MomentumCase(),
            new EnergyCase(),
            new SloshingCase(),
            new ViolentCase(),
        };
    }
}
