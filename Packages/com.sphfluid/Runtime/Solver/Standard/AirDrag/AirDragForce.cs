using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Drag of still air on what is at the surface: Shaders/Solver/Standard/AirDrag. It is taken implicitly and sets no limit of the step.
    /// </summary>
    internal sealed class AirDragForce : ParticleForce
    {
        // Of a sphere between Reynolds numbers of 10³ and 10⁵ (Hoerner 1965).
        private const double Coefficient = 0.47;

        public override FluidMethodFeatures Feature => FluidMethodFeatures.AirDrag;

        public override string CostVariant => "+drag";

        public override int Walks => 0;

        public override IReadOnlyList<string> Shaders { get; } = new[] { "AirDrag" };

        public override IReadOnlyList<string> ProfileFields { get; } = new[] { "airDensity" };

        /// <summary>
        /// Drag of a particle in the open over its speed squared [1/m]: 3/4 C ρ_air/(ρ0 d), d = (6/π)^⅓ dx the diameter of a ball of its
        /// volume.
        /// </summary>
        public static double Rate(in FluidSolverSettings settings) =>
            0.75 * Coefficient * settings.Own<StandardSettings>().AirDensity /
            (settings.RestDensity * Math.Pow(6.0 / Math.PI, 1.0 / 3.0) * settings.Spacing);

        public override void Derive(in FluidRuleInput input, ref StandardSettings settings) => settings.AirDensity = input.AirDensity;

        public override void Validate(in StandardSettings settings) =>
            Require.NotNegative(settings.AirDensity, nameof(settings.AirDensity));

        public override bool Acts(in StandardSettings settings) => settings.AirDensity > 0f;

        public override string Describe(in FluidRuleInput input) =>
            FormattableString.Invariant($"air drag, which acts in air of {input.AirDensity:G3} kg/m³");

        public override BufferSet MakeBuffers(int particleCount, bool isPlanned) => new NoBuffers();

        public override ForcePasses MakePasses(FluidShaderSet shaders) => new Passes(shaders);

        private sealed class NoBuffers : BufferSet
        {
        }

        private sealed class Passes : ForcePasses
        {
            private readonly AirDragPass drag;

            public Passes(FluidShaderSet shaders)
            {
                drag = new AirDragPass(shaders);
            }

            public override void Record(CommandBuffer cmd, StandardState state, in FluidStep step) => drag.Record(cmd, state, step);
        }
    }
}
