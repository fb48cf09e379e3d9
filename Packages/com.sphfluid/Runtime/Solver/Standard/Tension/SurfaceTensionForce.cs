using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Surface tension by the pull of pairs and of normals, and the wetting of walls: Shaders/Solver/Standard/Tension.</summary>
    internal sealed class SurfaceTensionForce : ParticleForce
    {
        public override FluidMethodFeatures Feature => FluidMethodFeatures.SurfaceTension;

        public override string CostVariant => "+tension";

        public override int Walks => 2;

        public override IReadOnlyList<string> Shaders { get; } = new[] { "SurfaceNormals", "SurfaceTension" };

        public override IReadOnlyList<string> ProfileFields { get; } = new[] { "surfaceTension", "tensionAtAnySpacing", "contactAngle" };

        /// <summary>True: its constants are calibrated with the whole profile.</summary>
        public override bool NeedsWholeWalls => true;

        public override void Derive(in FluidRuleInput input, ref StandardSettings settings)
        {
            settings.ContactAngle = input.ContactAngle;
            settings.SurfaceTension = CapillaryRules.Acts(input) ? input.SurfaceTension : 0f;
            if (settings.SurfaceTension > 0f && input.SupportRatio < CapillaryRules.LeastRatio)
            {
                throw new ArgumentException(FormattableString.Invariant(
                    $"The Support Ratio is {input.SupportRatio:G3}; surface tension needs {CapillaryRules.LeastRatio} or more. Raise ") +
                    "it, or set Surface Tension to 0.");
            }
        }

        public override void Validate(in StandardSettings settings)
        {
            Require.NotNegative(settings.SurfaceTension, nameof(settings.SurfaceTension));
            Require.Within(settings.ContactAngle, 0.0, 180.0, nameof(settings.ContactAngle));
        }

        public override bool Acts(in StandardSettings settings) => settings.SurfaceTension > 0f;

        public override string Describe(in FluidRuleInput input) =>
            FormattableString.Invariant($"surface tension, which acts in this liquid at a spacing of {1e3 * input.Spacing:G3} mm");

        public override double LeastSoundSpeed(in FluidRuleInput input, in StandardSettings settings) => Acts(settings)
            ? CapillaryRules.LeastSoundSpeed(settings.SurfaceTension, input.RestDensity, input.Spacing, input.SupportRatio,
                input.MaxCompression)
            : 0.0;

        public override double LargestStep(in FluidSolverSettings settings) =>
            CapillaryRules.LargestStep(settings.Own<StandardSettings>().SurfaceTension, settings.RestDensity, settings.Spacing);

        public override BufferSet MakeBuffers(int particleCount, bool isPlanned) => new TensionBuffers(particleCount, isPlanned);

        public override ForcePasses MakePasses(FluidShaderSet shaders) => new Passes(shaders);

        private sealed class Passes : ForcePasses
        {
            private readonly SurfaceNormalsPass normals;
            private readonly SurfaceTensionPass tension;

            public Passes(FluidShaderSet shaders)
            {
                normals = new SurfaceNormalsPass(shaders);
                tension = new SurfaceTensionPass(shaders);
            }

            public override void Record(CommandBuffer cmd, StandardState state, in FluidStep step)
            {
                normals.Record(cmd, state);
                tension.Record(cmd, state, step);
            }
        }
    }
}
