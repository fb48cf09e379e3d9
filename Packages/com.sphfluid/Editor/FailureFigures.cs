using System;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using SphFluid.Validation;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Figures and findings of <see cref="FailureExperiments"/> on the console, for Documentation~/failure-modes.md.</summary>
    public static class FailureFigures
    {
        const string AuditShader = "Packages/com.sphfluid/Validation/Measure/NeighbourAudit.compute";

        /// <summary>
        /// Entry point for <c>-batchmode -executeMethod SphFluid.Editor.FailureFigures.Write</c>; <c>--only NAME</c> runs one experiment.
        /// </summary>
        public static void Write()
        {
            string[] words = Environment.GetCommandLineArgs();
            int index = Array.IndexOf(words, "--only");
            string only = index >= 0 && index + 1 < words.Length ? words[index + 1] : null;
            var audit = AssetDatabase.LoadAssetAtPath<ComputeShader>(AuditShader);
            Console.WriteLine(SystemInfo.graphicsDeviceName);
            foreach (FailureExperiment experiment in FailureExperiments.All().Where(e => only == null || e.Name == only))
            {
                Write(experiment, false, audit);
                Write(experiment, true, audit);
            }
        }

        static void Write(FailureExperiment experiment, bool cured, ComputeShader audit)
        {
            var watch = Stopwatch.StartNew();
            FailureResult result = experiment.Run(cured, PackageAssets.Shaders, audit);
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "{0} {1}: {2:G4} {3} [{4}] {5} particles, {6} steps, {7:0.0} s", experiment.Name,
                cured ? "cured" : experiment.Survived ? "stress" : "failing", result.Figure, experiment.Figure, result.Named, result.Run.Start.Length,
                result.Run.Steps, watch.Elapsed.TotalSeconds));
            if (Environment.GetCommandLineArgs().Contains("--series"))
                foreach (FluidVitals v in result.Vitals)
                    Console.WriteLine(FormattableString.Invariant($"  t {v.Time:0.000} Ek {v.KineticEnergy:G4} Ep {v.PotentialEnergy:G5} Ee {v.ElasticEnergy:G4} vrms {v.RmsSpeed(result.Settings.ParticleMass):G3} chk {v.Checkerboard:0.00} comp {v.MeanCompression:0.000} max {v.MaxDensityRatio:0.00} min {v.MinDensityRatio:0.00} clump {v.Clumped} walls {v.AtWalls} crowd {v.WallCrowding:0.00} vmax {v.MaxSpeed:G3}"));
            foreach (FluidFinding finding in result.Findings)
                Console.WriteLine($"    {finding.Failure}: {finding.Text} {finding.Cure}");
        }
    }
}
