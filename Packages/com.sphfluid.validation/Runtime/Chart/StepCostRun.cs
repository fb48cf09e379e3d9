using System;
using System.Collections;
using System.Diagnostics;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// Times the step of a liquid: ¼ m³ of water that falls as a block in a cube of 1 m, whatever its number of particles.
    /// </summary>
    internal sealed class StepCostRun
    {
        private const long LeastSteps = 12, MostSteps = 2000;
        private const int EngineFramesToWait = 400;

        private readonly FluidShaderSet shaders;

        public StepCostRun(FluidShaderSet shaders) => this.shaders = shaders;

        /// <summary>Least time of a timing [s].</summary>
        internal double LeastSeconds { get; set; } = 1.0;

        /// <summary>The timing; it yields where a frame of the engine has to go by.</summary>
        public IEnumerator Run(StepCostPoint point, Action<StepCostRow> done)
        {
            FluidParticle[] block = BenchLiquid.Block(point.Particles, false, out float spacing, out float height);
            using (var solver = new FluidSolver(Settings(point, spacing, height), shaders, block))
            {
                GatherNeighbours(solver);
                using (var stepper = new CaseStepper(solver, true))
                {
                    // Pipelines are built.
                    for (int i = 0; i < 3; i++)
                    {
                        stepper.Step(long.MaxValue);
                        yield return null;
                    }
                    yield return WaitForTimes(stepper);
                    stepper.Restart();
                    for (var clock = Stopwatch.StartNew(); IsShort(stepper.Steps, clock);)
                    {
                        stepper.Step(MostSteps - stepper.Steps);
                        yield return null;
                        stepper.Collect();
                    }
                    yield return WaitForTimes(stepper);
                    done(StepCostRow.Of(point, stepper.Steps, stepper.GpuTimes));
                }
            }
        }

        private bool IsShort(long steps, Stopwatch clock) => steps < LeastSteps || steps < MostSteps &&
            clock.Elapsed.TotalSeconds < LeastSeconds;

        private static FluidSolverSettings Settings(StepCostPoint point, float spacing, float height)
        {
            FluidRuleInput rules = FluidRuleInput.Water;
            rules.Method = point.Method.Kind;
            rules.GradientCorrection = point.Method.CorrectsGradient;
            rules.DomainSize = Vector3.one * BenchLiquid.Edge;
            rules.Spacing = spacing;
            rules.SupportRatio = (float)point.SupportRatio;
            rules.LiquidHeight = height;
            rules.LiquidDepth = height;
            FluidSolverSettings settings = FluidRules.Derive(rules);
            settings.OctantSearch = false; // as in the cases
            return settings;
        }

        private static void GatherNeighbours(FluidSolver solver)
        {
            using (var cmd = new CommandBuffer { name = "Step Cost" })
            {
                solver.RecordNeighbourSetup(cmd);
                Graphics.ExecuteCommandBuffer(cmd);
            }
        }

        private static IEnumerator WaitForTimes(CaseStepper stepper)
        {
            for (int waited = 0; !stepper.Collect(); waited++)
            {
                if (waited == EngineFramesToWait)
                {
                    throw new FluidDeviceException(
                        $"{SystemInfo.graphicsDeviceName} gave no GPU times within {EngineFramesToWait} frames.");
                }
                yield return null;
            }
        }
    }
}
