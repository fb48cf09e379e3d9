using System;
using System.Globalization;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation.Editor
{
    /// <summary>
    /// Pictures of what the thesis's printed forms do, for Documentation~/printed-forms.md: thesis-NAME.png for each of
    /// <see cref="SwitchCatalogue"/>, corrected on the left and printed on the right, and a line of figures on the console.
    /// </summary>
    public static class SwitchFigures
    {
        private const int PanelHeight = 320;
        private const int MaxPanelWidth = 280;

        /// <summary>
        /// Entry point for <c>-batchmode -executeMethod SphFluid.Validation.Editor.SwitchFigures.Write</c>; <c>--out DIR</c> names the
        /// folder, <c>--only NAME</c> one experiment.
        /// </summary>
        public static void Write() => FigureSession.Write(SwitchCatalogue.All(), e => e.Name, "thesis", FigureSession.PackageImages, Run);

        private static ParticlePicture Run(SwitchExperiment experiment)
        {
            SwitchResult corrected = experiment.Run(false, SessionAssets.PackageShaders);
            SwitchResult printed = experiment.Run(true, SessionAssets.PackageShaders);
            Vector3 box = experiment.Corrected.DomainSize;
            float panelHeight = experiment.FromAbove ? box.z : box.y;
            float scale = Mathf.Min(PanelHeight / panelHeight, MaxPanelWidth / box.x);
            var picture = new ParticlePicture(2, Mathf.RoundToInt(scale * box.x), Mathf.RoundToInt(scale * panelHeight));
            Draw(picture, 0, corrected, experiment);
            Draw(picture, 1, printed, experiment);
            Console.WriteLine($"{experiment.Name}: corrected {Figures(corrected)}; printed {Figures(printed)}");
            return picture;
        }

        private static void Draw(ParticlePicture picture, int panel, SwitchResult result, SwitchExperiment experiment)
        {
            FluidSolverSettings settings = result.Settings;
            var value = new float[result.Particles.Length];
            for (int i = 0; i < value.Length; i++)
            {
                switch (experiment.Color)
                {
                    case SwitchColor.Pressure:
                        value[i] = result.Pressure[i] / (2f * settings.RestDensity * settings.Gravity.magnitude * settings.DomainSize.y);
                        break;
                    case SwitchColor.Speed:
                        value[i] = result.Particles[i].VelT1.magnitude / 0.3f;
                        break;
                    default:
                        value[i] = (result.Density[i] / settings.RestDensity - 1f) / 0.3f;
                        break;
                }
            }
            picture.Draw(panel, result.Particles, value, settings.DomainSize, experiment.FromAbove, 0.4f * settings.Spacing);
        }

        private static string Figures(SwitchResult result) => string.Format(CultureInfo.InvariantCulture,
            "height {0:0.0000} m, speed {1:0.000} m/s, extent {2:0.0000} m, nearer than dx/2 {3:0.000}, slope {4:0.000}, limit hits {5}, " +
            "not finite {6}",
            result.MeanHeight, result.MeanSpeed, result.Extent, result.Clumped(0.5f), result.PressureSlope,
            result.Counters.AccelerationLimitHits, result.Counters.NonFinite);
    }
}
