using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Marks the particles that sleep, behind a sort, and finds out which do from the next one on.</summary>
    internal sealed class SleepParticlesPass : ComputePass
    {
        private static readonly int BrickCounts = Id("_BrickCounts");
        private static readonly int BrickTotal = Id("_BrickTotal");
        private static readonly int SpeedUnit = Id("_SpeedUnit");
        private static readonly int CalmUnits = Id("_CalmUnits");
        private static readonly int MostDrift = Id("_MostDrift");
        private static readonly int DriftTime = Id("_DriftTime");
        private static readonly int SinceSort = Id("_SinceSort");
        private static readonly int CalmTime = Id("_CalmTime");
        private static readonly int StillTime = Id("_StillTime");
        private static readonly int Slowing = Id("_Slowing");
        private static readonly int Softened = Id("_Softened");
        private static readonly int Stiffening = Id("_Stiffening");
        private static readonly int RestDensity = Id("_RestDensity");
        private static readonly int SupportSquared = Id("_SupportSquared");

        // Units of velocity in the speed of a still brick: the least that is told apart.
        private const float StillUnits = 2f;

        private static readonly int SleptStiffness = Id("_SleptStiffness");
        private static readonly int OfSleepers = Id("_OfSleepers");

        private readonly ComputeKernel wake, sum, mark, rest, soften, count, judge, spread;

        public SleepParticlesPass(FluidShaderSet shaders)
            : base(shaders, "SleepParticles")
        {
            wake = Kernel("WakeSleepers");
            sum = Kernel("SumBricks");
            mark = Kernel("MarkSleepers");
            rest = Kernel("RestSleepers");
            soften = Kernel("SoftenPressures");
            count = Kernel("CountSleepers");
            judge = Kernel("JudgeBricks");
            spread = Kernel("SpreadSleep");
        }

        /// <summary>Behind a sort.</summary>
        public void Record(CommandBuffer cmd, CellState state)
        {
            SleepBricks bricks = state.Sleep;
            using (Sample(cmd))
            {
                RecordSums(cmd, state);
                RecordJudgement(cmd, state, bricks.SinceSort);
                RecordMarks(cmd, state);
            }
            bricks.SinceSort = 0f;
        }

        /// <summary>Wakes the particles of the bricks that are to wake, between two sorts.</summary>
        public void RecordWake(CommandBuffer cmd, CellState state)
        {
            using (Sample(cmd))
            {
                RecordJudgement(cmd, state, 0f);
                Bind(cmd, wake, state);
                CellBindings.SetCells(cmd, wake, state);
                wake.SetFloat(cmd, SupportSquared, state.Settings.SupportRadius * state.Settings.SupportRadius);
                wake.SetOut(cmd, state.Buffers.Positions);
                state.Sleep.Groups.Begin(cmd, wake, state);
                wake.DispatchThreads(cmd, state.ParticleCount);
            }
        }

        /// <summary>What a density pass, and each step from there on, would find of those that sleep.</summary>
        public void RecordRest(CommandBuffer cmd, CellState state)
        {
            FluidSolverSettings settings = state.Settings;
            using (Sample(cmd))
            {
                CellBindings.SetCells(cmd, rest, state);
                rest.SetFloat(cmd, RestDensity, settings.RestDensity);
                CellBindings.SetSuction(cmd, rest, settings);
                rest.SetFloat(cmd, SleptStiffness, state.Sleep.Stiffness);
                rest.Set(cmd, state.Buffers.Positions);
                rest.Set(cmd, state.Buffers.Velocities);
                rest.SetOut(cmd, state.Buffers.PositionTerms);
                rest.SetOut(cmd, state.Buffers.NewPositions);
                rest.SetOut(cmd, state.Buffers.NewVelocities);
                rest.SetOut(cmd, state.List.Counts);
                rest.SetOut(cmd, state.List.Densities);
                rest.Set(cmd, state.Published.Counters);
                rest.DispatchThreads(cmd, state.ParticleCount);
            }
        }

        /// <summary>Behind a density pass: what sleeps is as soft as when it fell asleep, and what woke stiffens.</summary>
        /// <param name="cmd">Receives the pass.</param>
        /// <param name="state">The liquid.</param>
        /// <param name="hasRested">Whether <see cref="RecordRest"/> came before it.</param>
        public void RecordSoftness(CommandBuffer cmd, CellState state, bool hasRested)
        {
            if (!state.Sleep.IsSoft) return;
            using (Sample(cmd))
            {
                Bind(cmd, soften, state);
                CellBindings.SetCells(cmd, soften, state);
                soften.SetOut(cmd, state.Buffers.PositionTerms);
                soften.Set(cmd, state.List.Counts);
                soften.Set(cmd, state.Published.Counters);
                soften.SetInt(cmd, OfSleepers, hasRested ? 1 : 0);
                if (hasRested) AwakeGroups.DispatchAll(cmd, soften, state);
                else AwakeGroups.Dispatch(cmd, soften, state);
            }
        }

        /// <summary>The end of a step for the groups that its passes left out.</summary>
        public void RecordCount(CommandBuffer cmd, CellState state, in FluidStep step)
        {
            if (!state.Sleep.Groups.AreListed || step.KeepsOrder) return;
            using (Sample(cmd))
            {
                CellBindings.SetCells(cmd, count, state);
                DomainBindings.SetFaces(cmd, count, state.Settings);
                CellBindings.SetCounting(cmd, count, state, step);
                count.Set(cmd, state.Buffers.PositionTerms);
                count.Set(cmd, state.List.Densities);
                count.Set(cmd, state.Published.Counters);
                state.Sleep.Groups.DispatchAsleep(cmd, count, state);
            }
        }

        private void RecordSums(CommandBuffer cmd, CellState state)
        {
            Bind(cmd, sum, state);
            CellBindings.SetCells(cmd, sum, state);
            sum.Set(cmd, state.Buffers.Positions);
            sum.Set(cmd, state.Buffers.Velocities);
            sum.Set(cmd, state.Buffers.PositionTerms);
            sum.Set(cmd, state.Published.Counters);
            sum.DispatchThreads(cmd, state.ParticleCount);
        }

        private void RecordMarks(CommandBuffer cmd, CellState state)
        {
            SleepRule rule = state.Sleep.Rule;
            Bind(cmd, mark, state);
            CellBindings.SetCells(cmd, mark, state);
            mark.SetFloat(cmd, Slowing, Mathf.Exp(-state.Sleep.SinceSort / rule.FadeTime));
            mark.SetOut(cmd, state.Buffers.Positions);
            mark.SetOut(cmd, state.Buffers.Velocities);
            mark.Set(cmd, state.Buffers.PositionTerms);
            state.Sleep.Groups.Begin(cmd, mark, state);
            mark.DispatchThreads(cmd, state.ParticleCount);
        }

        private void RecordJudgement(CommandBuffer cmd, CellState state, float since)
        {
            SleepRule rule = state.Sleep.Rule;
            float unit = Unit(rule);
            Bind(cmd, judge, state);
            CellBindings.SetCells(cmd, judge, state.Cells);
            var calm = new Vector3(Square(rule.JitterSpeed / unit), Square(rule.DriftSpeed / unit), Square(StillUnits));
            if (state.Sleep.AllWake) calm = -Vector3.one;
            judge.SetVector(cmd, CalmUnits, calm);
            judge.SetFloat(cmd, MostDrift, rule.MostDrift);
            judge.SetFloat(cmd, DriftTime, rule.DriftTime);
            judge.SetFloat(cmd, SinceSort, since);
            judge.Set(cmd, state.Sleep.AwakeBoxes);
            judge.DispatchThreads(cmd, state.Sleep.Total);
            Bind(cmd, spread, state);
            DomainBindings.SetPeriodic(cmd, spread, state.Settings);
            spread.SetVector(cmd, CalmUnits, calm);
            spread.SetFloat(cmd, Softened, state.Sleep.TakeStiffness(Square(state.Settings.SoundSpeed)));
            spread.SetFloat(cmd, Stiffening, Mathf.Exp(-since / rule.StillTime));
            spread.DispatchThreads(cmd, state.Sleep.Total);
            state.Sleep.Woke();
        }

        private static void Bind(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            SleepBricks bricks = state.Sleep;
            kernel.SetOut(cmd, bricks.Bricks);
            kernel.SetInt(cmd, BrickTotal, bricks.Total);
            kernel.SetInts(cmd, BrickCounts, bricks.Shape);
            kernel.SetFloat(cmd, SpeedUnit, Unit(bricks.Rule));
            kernel.SetFloat(cmd, CalmTime, bricks.Rule.CalmTime);
            kernel.SetFloat(cmd, StillTime, bricks.Rule.StillTime);
        }

        private static float Unit(in SleepRule rule) => rule.StillSpeed / StillUnits;

        private static float Square(float value) => value * value;
    }
}
