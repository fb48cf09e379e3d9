using System;
using System.Globalization;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Validation.Editor
{
    /// <summary>
    /// Figures and findings of <see cref="FailureCatalogue"/> on the console, and pictures failure-NAME.png, failing on the left and
    /// cured on the right, for Documentation~/failure-modes.md.
    /// </summary>
    public static class FailureFigures
    {
        private const string AuditShader = "Packages/com.sphfluid.validation/Runtime/Measure/NeighbourAudit.compute";
        private const int PanelHeight = 280;

        /// <summary>
        /// Entry point for <c>-batchmode -executeMethod SphFluid.Validation.Editor.FailureFigures.Write</c>; <c>--only NAME</c> runs one
        /// experiment, <c>--out DIR</c> writes pictures.
        /// </summary>
        public static void Write()
        {
            var audit = AssetDatabase.LoadAssetAtPath<ComputeShader>(AuditShader);
            FigureSession.Write(FailureCatalogue.All(), e => e.Name, "failure", null, e => Draw(Run(e, false, audit), Run(e, true, audit)));
        }

        private static FailureResult Run(FailureExperiment experiment, bool cured, ComputeShader audit)
        {
            FailureResult result = experiment.Run(cured, SessionAssets.PackageShaders, audit);
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "{0} {1}: {2:G4} {3}; {4}; {5} particles, {6} steps",
                experiment.Name,
                cured ? "cured" : experiment.Survived ? "stress" : "failing", result.Figure, experiment.Figure, result.Named,
                result.Run.Start.Length,
                result.Run.Steps));
            foreach (FluidFinding finding in result.Findings) Console.WriteLine($"    {finding.Failure}: {finding.Text} {finding.Cure}");
            return result;
        }

        // Blue to red: density from 0.7 to 1.3 of the rest density.
        private static ParticlePicture Draw(FailureResult failing, FailureResult cured)
        {
            Vector3 box = failing.Settings.DomainSize;
            var picture = new ParticlePicture(2, Mathf.RoundToInt(PanelHeight * box.x / box.y), PanelHeight);
            int panel = 0;
            foreach (FailureResult result in new[] { failing, cured })
            {
                FluidSnapshot end = result.End;
                FluidParticle[] particles = Enumerable.Range(0, end.Count)
                    .Select(i => new FluidParticle(end.LocalPositions[i], Vector3.zero, (uint)i)).ToArray();
                float[] value = end.Densities.Select(d => (d / result.Settings.RestDensity - 0.7f) / 0.6f).ToArray();
                picture.Draw(panel++, particles, value, box, false, 0.4f * result.Settings.Spacing);
            }
            return picture;
        }
    }
}
