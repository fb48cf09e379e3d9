using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Particles that fall and feel nothing of each other: spray, or the least that a method can be.</summary>
    internal sealed class BallisticMethod : FluidMethod
    {
        private static readonly ShaderGroup Group = new ShaderGroup("the ballistic method", "Shaders/Solver/Ballistic",
            groupThreads: 256, buffers: 1, writableBuffers: 1, groupMemory: 0, vertexBuffers: 0, "Fly");

        public override FluidMethodKind Kind => FluidMethodKind.Ballistic;

        public override FluidMethodFeatures Features => FluidMethodFeatures.None;

        public override ShaderGroup Shaders => Group;

        public override IReadOnlyList<string> ProfileFields => Array.Empty<string>();

        public override long MaxCells => int.MaxValue;

        public override double PassesAStep => 0.0;

        public override FluidSolverSettings Derive(in FluidRuleInput input)
        {
            double fall = 2.0 * input.Gravity.magnitude * input.LiquidHeight;
            double speed = Math.Max(input.MinSpeed, Math.Sqrt((double)input.InitialSpeed * input.InitialSpeed + fall));
            double step = input.FixedTimeStep > 0f ? input.FixedTimeStep : TimeStepAdvice.SpeedStep(input.Spacing, speed);
            return new FluidSolverSettings
            {
                Method = Kind,
                DomainSize = input.DomainSize,
                Spacing = input.Spacing,
                SupportRadius = input.SupportRatio * input.Spacing,
                RestDensity = input.RestDensity,
                ParticleMass = input.RestDensity * input.Spacing * input.Spacing * input.Spacing,
                TimeStep = (float)step,
                Gravity = input.Gravity,
                MaxSpeed = (float)speed,
            }.WithOwn(new BallisticSettings { SoundSpeed = (float)(input.SoundSpeedRatio * speed) });
        }

        public override TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed) => new TimeStepAdvice(
            double.PositiveInfinity, TimeStepAdvice.SpeedStep(settings.Spacing, maxSpeed), double.PositiveInfinity,
            double.PositiveInfinity, double.PositiveInfinity, settings.SoundSpeed, maxSpeed, 0.0);

        public override IFluidStepper Start(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount) =>
            new BallisticStepper(settings, shaders, particleCount);

        public override long PlannedBytes(in FluidSolverSettings settings, int particleCount, bool hasBodies)
        {
            using (var state = new BallisticState(settings, particleCount, true)) return state.Bytes;
        }
    }
}
