using System;
using SphFluid.Laboratory;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Runs one side of an experiment on the GPU, with the detectors watching.</summary>
    internal sealed class FailureRunner : IDisposable
    {
        private const string Name = "Failure Experiment";

        private readonly FailureRun run;
        private readonly ComputeShader audit;
        private readonly FluidSolver solver;
        private readonly FluidStatisticsMeter meter;
        private readonly FluidDetectors detectors;
        private readonly CaseObstacles sheets;

        public FailureRunner(FailureRun run, FluidShaderSet shaders, ComputeShader audit)
        {
            this.run = run;
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
                SolverLaboratory.SetUnchecked(solver, wrong);
            }
            result.Note(detectors.Check());
            if (run.Later != null) SortTwice();
            Look(result);
            for (int sample = 0; sample < run.Samples && run.Steps > 0; sample++)
            {
                GpuWork.Step(Name, solver, (sample + 1L) * run.Steps / run.Samples - solver.StepCount);
                Look(result);
            }
            result.Counters = solver.ReadCountersNow();
            if (audit != null)
            {
                GpuWork.Submit(Name, cmd => solver.RecordNeighbourSetup(cmd));
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

        private void Look(FailureResult result)
        {
            FluidStatistics now = meter.MeasureNow();
            result.Note(detectors.Update(now, solver.ReadCountersNow()));
            result.Add(now, FluidSnapshot.Read(solver));
        }

        // The blocks of 6.2 at two places, the second time with or without 6.2.4, Reset Grid Indices.
        private void SortTwice()
        {
            GpuWork.Submit(Name, cmd => solver.RecordNeighbourSetup(cmd));
            solver.Particles.SetData(run.Later);
            GpuWork.Submit(Name, cmd => SolverLaboratory.RecordNeighbourSetup(solver, cmd, run.RangesKept ? "ResetGridIndices" : null));
        }
    }
}
