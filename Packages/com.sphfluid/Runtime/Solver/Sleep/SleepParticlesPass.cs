using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Marks the particles that sleep, behind a sort, and finds out which do from the next one on.</summary>
    internal sealed class SleepParticlesPass : ComputePass
    {
        private static readonly int BrickCounts = Id("_BrickCounts");
        private static readonly int BrickTotal = Id("_BrickTotal");
        private static readonly int AwakeBoxCount = Id("_AwakeBoxCount");
        private static readonly int SpeedUnit = Id("_SpeedUnit");
        private static readonly int FastSquared = Id("_FastSquared");
        private static readonly int DriftSquared = Id("_DriftSquared");
        private static readonly int SinceSort = Id("_SinceSort");
        private static readonly int CalmTime = Id("_CalmTime");

        private const float UnitsOfDrift = 16f;

        private readonly ComputeKernel clear, mark, judge, spread;

        public SleepParticlesPass(FluidShaderSet shaders)
            : base(shaders, "SleepParticles")
        {
            clear = Kernel("ClearSleep");
            mark = Kernel("MarkSleepers");
            judge = Kernel("JudgeBricks");
            spread = Kernel("SpreadSleep");
        }

        public void Record(CommandBuffer cmd, CellState state)
        {
            SleepBricks bricks = state.Sleep;
            SleepRule rule = bricks.Rule;
            using (Sample(cmd))
            {
                if (bricks.IsNew)
                {
                    Bind(cmd, clear, state);
                    clear.DispatchThreads(cmd, bricks.Total * SleepBricks.Words);
                    bricks.IsNew = false;
                }
                Bind(cmd, mark, state);
                CellBindings.SetCells(cmd, mark, state);
                mark.SetFloat(cmd, SpeedUnit, rule.Drift / UnitsOfDrift);
                mark.SetOut(cmd, state.Buffers.Positions);
                mark.SetOut(cmd, state.Buffers.Velocities);
                mark.Set(cmd, state.Buffers.PositionTerms);
                mark.SetFloat(cmd, Id("_Drowsy"), UnityEngine.Mathf.Exp(-bricks.SinceSort / rule.Tau));
                mark.DispatchThreads(cmd, state.ParticleCount);
                Bind(cmd, judge, state);
                CellBindings.SetCells(cmd, judge, state.Cells);
                judge.SetInt(cmd, AwakeBoxCount, bricks.BoxCount);
                judge.SetFloat(cmd, SpeedUnit, rule.Drift / UnitsOfDrift);
                judge.SetFloat(cmd, FastSquared, rule.Fastest * rule.Fastest);
                judge.SetFloat(cmd, DriftSquared, rule.Drift * rule.Drift);
                judge.SetFloat(cmd, SinceSort, bricks.SinceSort);
                judge.SetFloat(cmd, CalmTime, rule.CalmTime);
                judge.Set(cmd, bricks.AwakeBoxes);
                judge.SetFloat(cmd, Id("_StillSquared"), rule.Still * rule.Still);
                judge.SetFloat(cmd, Id("_DrowsyFrom"), rule.CalmTime - 5f * rule.Tau);
                judge.DispatchThreads(cmd, bricks.Total);
                Bind(cmd, spread, state);
                DomainBindings.SetPeriodic(cmd, spread, state.Settings);
                spread.SetFloat(cmd, CalmTime, rule.CalmTime);
                spread.SetFloat(cmd, Id("_DrowsyFrom"), rule.CalmTime - 5f * rule.Tau);
                spread.DispatchThreads(cmd, bricks.Total);
            }
            bricks.SinceSort = 0f;
        }

        private static void Bind(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            SleepBricks bricks = state.Sleep;
            kernel.SetOut(cmd, bricks.Bricks);
            kernel.SetInt(cmd, BrickTotal, bricks.Total);
            kernel.SetInts(cmd, BrickCounts, new[] { bricks.Counts.x, bricks.Counts.y, bricks.Counts.z, bricks.Side });
        }
    }
}
