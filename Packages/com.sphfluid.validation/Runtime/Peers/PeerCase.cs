using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A case that PySPH can express, and how its authors run such a flow; the rest of that is in Peers~/pysph_case.py.</summary>
    sealed class PeerCase
    {
        // All of the examples have a speed of sound of ten times the fastest speed.
        const double AuthorsSoundSpeedRatio = 10.0;

        readonly int layers;

        PeerCase(string name, string method, int layers = 0)
        {
            Case = CaseCatalogue.All.First(c => c.Name == name);
            Method = method;
            this.layers = layers;
        }

        /// <summary>The cases, in the order of the chart.</summary>
        public static IReadOnlyList<PeerCase> All { get; } = new[]
        {
            new PeerCase("ellipsoid", "pysph-wcsph"),
            new PeerCase("hydrostatic", "pysph-adami", layers: 1),
            new PeerCase("poiseuille", "pysph-tvf"),
            new PeerCase("couette", "pysph-tvf"),
            new PeerCase("dam-break", "pysph-wcsph", layers: 2),
            new PeerCase("marin", "pysph-wcsph"),
        };

        /// <summary>The case.</summary>
        public ValidationCase Case { get; }

        /// <summary>Name in tables: the program and its scheme.</summary>
        public string Method { get; }

        /// <summary>
        /// The runs: at two coarser spacings and the case's own with the speed of sound of PySPH's authors, and there with the case's too.
        /// </summary>
        /// <param name="quick">Whether only the coarsest is run.</param>
        public IEnumerable<PeerPoint> Points(bool quick)
        {
            CaseParameters start = Case.Base(CaseMethod.Of(FluidMethodKind.Standard));
            foreach (double scale in quick ? new[] { 0.5 } : new[] { 0.5, 0.67, 1.0 })
                yield return new PeerPoint(this, (int)Math.Round(scale * start.Resolution), AuthorsSoundSpeedRatio);
            if (!quick && start.SoundSpeedRatio != AuthorsSoundSpeedRatio)
                yield return new PeerPoint(this, start.Resolution, start.SoundSpeedRatio);
        }

        /// <summary>
        /// Density of a particle at the start [kg/m³]: at rest that of a column that its weight compresses, where the case starts so; ρ0 elsewhere.
        /// With p = c² (ρ − ρ0) and c² = m g H, <see cref="WallCaseSetup.Settled"/> has ρ/ρ0 = e^((h − s)/(m H)) at the height s of a column of height h.
        /// </summary>
        /// <param name="setup">The set-up.</param>
        /// <param name="resolution">Particles along the case's length.</param>
        /// <param name="position">The particle's place [m].</param>
        public float DensityAt(CaseSetup setup, int resolution, Vector3 position)
        {
            FluidSolverSettings settings = setup.Settings;
            if (layers == 0)
                return settings.RestDensity;
            double depth = layers * resolution * (double)settings.Spacing, sound = CaseSettings.EffectiveSoundSpeed(settings);
            double m = sound * sound / (-settings.Gravity.y * depth);
            double below = WallCaseSetup.Settled(depth, depth, m) - (position.y + 0.5 * settings.DomainSize.y);
            return (float)(settings.RestDensity * Math.Exp(below / (m * depth)));
        }
    }
}
