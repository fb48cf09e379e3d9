using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A case that PySPH can express, and how its authors run such a flow; the rest of that is in Peers~/pysph_case.py.</summary>
    internal sealed class PeerCase
    {
        // All of the examples have a speed of sound of ten times the fastest speed.
        private const double AuthorsSoundSpeedRatio = 10.0;

        private const double Coarse = 0.5;

        private readonly int layers;
        private readonly bool coarseOnly;

        private PeerCase(string name, string method, int layers = 0, bool coarseOnly = false)
        {
            Case = CaseCatalogue.All.First(c => c.Name == name);
            Method = method;
            this.layers = layers;
            this.coarseOnly = coarseOnly;
        }

        /// <summary>The cases, in the order of the chart.</summary>
        public static IReadOnlyList<PeerCase> All { get; } = new[]
        {
            new PeerCase("ellipsoid", "pysph-wcsph"),
            new PeerCase("hydrostatic", "pysph-adami", layers: 1, coarseOnly: true), // its own spacing takes some ten minutes
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
        /// The runs: at half of the case's resolution and at the case's own with the speed of sound of PySPH's authors, and at the finer of
        /// the two with the case's speed of sound where that is another one.
        /// </summary>
        /// <param name="quick">Whether only the coarsest is run.</param>
        public IEnumerable<PeerPoint> Points(bool quick)
        {
            CaseParameters start = Case.Base(CaseMethod.Of(FluidMethodKind.Standard));
            int coarse = (int)Math.Round(Coarse * start.Resolution), finest = coarseOnly ? coarse : start.Resolution;
            yield return new PeerPoint(this, coarse, AuthorsSoundSpeedRatio);
            if (quick) yield break;
            if (!coarseOnly) yield return new PeerPoint(this, finest, AuthorsSoundSpeedRatio);
            if (start.SoundSpeedRatio != AuthorsSoundSpeedRatio) yield return new PeerPoint(this, finest, start.SoundSpeedRatio);
        }

        /// <summary>
        /// Density of a particle at the start [kg/m³]: at rest that of a column that its weight compresses, where the case starts so; ρ0
        /// elsewhere. With p = c² (ρ − ρ0) and c² = m g H, <see cref="WallCaseSetup.Settled"/> has ρ/ρ0 = e^((h − s)/(m H)) at the height s
        /// of a column of height h.
        /// </summary>
        /// <param name="setup">The set-up.</param>
        /// <param name="resolution">Particles along the case's length.</param>
        /// <param name="position">The particle's place [m].</param>
        public float DensityAt(CaseSetup setup, int resolution, Vector3 position)
        {
            FluidSolverSettings settings = setup.Settings;
            if (layers == 0) return settings.RestDensity;
            double depth = layers * resolution * (double)settings.Spacing, sound = CaseSettings.EffectiveSoundSpeed(settings);
            double m = sound * sound / (-settings.Gravity.y * depth);
            double below = WallCaseSetup.Settled(depth, depth, m) - (position.y + 0.5 * settings.DomainSize.y);
            return (float)(settings.RestDensity * Math.Exp(below / (m * depth)));
        }
    }
}
