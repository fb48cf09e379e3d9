using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Buffers of the Robust method that a test fills by itself, to run one pass on them.</summary>
    internal sealed class RobustStateRig : CellStateRig<RobustState>
    {
        public RobustStateRig(in FluidSolverSettings settings, int particleCount) : base(new RobustState(settings, particleCount))
        {
        }

        /// <summary>Settings by rule for water of a depth of 0.3 m, κ = 2.25.</summary>
        public static FluidSolverSettings Robust(Vector3 domain, float spacing, FluidAxes periodic = FluidAxes.None)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Robust;
            input.DomainSize = domain;
            input.Spacing = spacing;
            input.LiquidHeight = input.LiquidDepth = 0.3f;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        /// <summary>Sorted random particles, with neighbours listed and multipliers as the first iteration finds them.</summary>
        public FluidParticle[] Constrained(float timeStep)
        {
            FluidParticle[] particles = FillSorted(ParticleSets.Random(State.ParticleCount, 0.9f * State.Settings.DomainSize, 1f, 5));
            var pass = new ConstrainDensityPass(Shaders);
            GpuTest.Run(cmd => pass.Record(cmd, State, RobustRules.Compliance(State.Settings, timeStep, timeStep, 1)));
            return particles;
        }
    }
}
