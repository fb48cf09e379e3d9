using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>Runs one side of an experiment on the GPU, with the detectors watching.</summary>
    sealed class FailureRunner : IDisposable
    {
        const int StepsPerBuffer = 50;

        readonly FailureRun run;
        readonly FluidShaderSet shaders;
        readonly ComputeShader audit;
        readonly FluidSolver solver;
        readonly FluidStatisticsMeter meter;
        readonly FluidDetectors detectors;
        readonly CaseObstacles sheets;

        public FailureRunner(FailureRun run, FluidShaderSet shaders, ComputeShader audit)
        {
            this.run = run;
            this.shaders = shaders;
            this.audit = audit;
            solver = new FluidSolver(run.Settings, shaders, run.Start);
            meter = new FluidStatisticsMeter(shaders, solver);
            detectors = new FluidDetectors(run.Settings, realViscosity: run.RealViscosity);
            sheets = new CaseObstacles(run.Sheets, false);
            sheets.GiveTo(solver);
        }

        public FailureResult Run()
        {
            var result = new FailureResult(run);
            if (run.EightCellsOfRadius)
            {
                FluidSolverSettings wrong = run.Settings;
                wrong.OctantSearch = true;
                solver.State.Settings = wrong;
            }
            result.Note(detectors.Check());
            if (run.Later != null)
                SortTwice();
            Look(result);
            for (int sample = 0; sample < run.Samples && run.Steps > 0; sample++)
            {
                Step((int)((sample + 1L) * run.Steps / run.Samples));
                Look(result);
            }
            result.Counters = solver.ReadCountersNow();
            if (audit != null)
            {
                Execute(cmd => solver.RecordNeighbourSetup(cmd));
                result.Audit = NeighbourAudit.Of(solver, audit);
                result.Note(result.Audit.Findings);
            }
            return result;
        }

        public void Dispose()
        {
            meter.Dispose();
            solver.Dispose();
            sheets.Dispose();
        }

        void Look(FailureResult result)
        {
            FluidStatistics now = meter.MeasureNow();
            result.Note(detectors.Note(now, solver.ReadCountersNow()));
            result.Add(now, FluidSnapshot.Read(solver));
        }

        void Step(int until)
        {
            while (solver.StepCount < until)
            {
                int now = (int)Math.Min(StepsPerBuffer, until - solver.StepCount);
                Execute(cmd => solver.RecordSteps(cmd, now));
            }
        }

        // The blocks of 6.2 at two places, the second time with or without 6.2.4, Reset Grid Indices.
        void SortTwice()
        {
            Execute(cmd => solver.RecordNeighbourSetup(cmd));
            solver.Particles.SetData(run.Later);
            var state = (ThesisState)solver.State;
            Execute(cmd =>
            {
                new CalculateParticleCellValuePass(shaders).Record(cmd, state);
                new BitonicSortPass(shaders).Record(cmd, state);
                if (!run.RangesKept)
                    new ResetGridIndicesPass(shaders).Record(cmd, state);
                new SetGridIndicesPass(shaders).Record(cmd, state);
                new SortParticlesPass(shaders).Record(cmd, state);
                new CalculateDensityPass(shaders).Record(cmd, state);
            });
        }

        static void Execute(Action<CommandBuffer> record)
        {
            using (var cmd = new CommandBuffer { name = "Failure Experiment" })
            {
                record(cmd);
                Graphics.ExecuteCommandBuffer(cmd);
            }
        }
    }
}
