using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// One experiment for each place where the thesis's text and the form that works part (<see cref="ThesisSwitches"/>).
    /// </summary>
    public static class SwitchCatalogue
    {
        // Suction tears a liquid of the rules' stiffness apart in hundredths of a second: a hundredth of it lets one see how.
        private const float Calm = 0.01f;

        private delegate void Change(ref ThesisSwitches switches);

        /// <summary>All, in the order of the chapters.</summary>
        public static IReadOnlyList<SwitchExperiment> All() => new[]
        {
            EightCells(), SelfDensity(), SelfDensityInFreeFall(), PressureClamp(), PressureHalf(), ForceTimesMass(), AccelerationLimit(),
            HalfKick(), AllPrinted(),
        };

        /// <summary>
        /// 6.2: 8 cells are enough only where cells are 2h wide; with cells of h pairs are lost, forces have no counterforce, and a column
        /// at rest boils.
        /// </summary>
        public static SwitchExperiment EightCells()
        {
            FluidParticle[] start = Column(0.025f, new Vector3Int(6, 14, 6), out FluidSolverSettings settings);
            FluidSolverSettings rows = settings;
            rows.OctantSearch = false;
            return new SwitchExperiment("eight-cells", start, 1.2f, settings, rows)
            {
                EightCellsOfSmoothLength = true,
                Color = SwitchColor.Speed
            };
        }

        /// <summary>
        /// 6.3.1: without itself a particle finds 0.81 of the density, and a column at rest shrinks until it finds all of it.
        /// </summary>
        public static SwitchExperiment SelfDensity()
        {
            FluidParticle[] start = Column(0.025f, new Vector3Int(6, 14, 6), out FluidSolverSettings settings);
            return One("self-density", start, 0.8f, settings, (ref ThesisSwitches s) => s.SelfDensity = false);
        }

        /// <summary>The same in free fall, where only suction can pull: both sides are without the clamp.</summary>
        public static SwitchExperiment SelfDensityInFreeFall()
        {
            FluidParticle[] start =
                Block(0.025f, new Vector3Int(9, 9, 9), new Vector3(0.4f, 0.7f, 0.4f), 0.2f, out FluidSolverSettings settings);
            settings.PressureClamp = false;
            settings = settings.WithOwn((ref ThesisSettings own) => own.Stiffness *= Calm);
            return One("free-fall", start, 0.2f, settings, (ref ThesisSwitches s) => s.SelfDensity = false);
        }

        /// <summary>Equation (10): a sheet without gravity; suction draws it into clumps.</summary>
        public static SwitchExperiment PressureClamp()
        {
            FluidParticle[] start =
                Block(0.025f, new Vector3Int(24, 1, 24), new Vector3(0.8f, 0.4f, 0.8f), 0f, out FluidSolverSettings settings);
            settings.Gravity = Vector3.zero;
            settings = settings.WithOwn((ref ThesisSettings own) => own.Stiffness *= Calm);
            SwitchExperiment experiment = One("pressure-clamp", start, 0.2f, settings, (ref ThesisSwitches s) => s.PressureClamp = false);
            experiment.FromAbove = true;
            return experiment;
        }

        /// <summary>Equation (13): to carry the same column its ½ needs twice the pressure. The other side has the full gradient.</summary>
        public static SwitchExperiment PressureHalf()
        {
            FluidParticle[] start = Column(0.025f, new Vector3Int(6, 14, 6), out FluidSolverSettings settings);
            ThesisSwitches full = ThesisSwitches.Corrected;
            full.PressureHalf = false;
            return new SwitchExperiment("pressure-half", start, 1.2f, settings.With(full), settings) { Color = SwitchColor.Pressure };
        }

        /// <summary>6.3.3 line 03: at 2.5 mm force times mass is about a sixtieth of f/ρ, and the column collapses.</summary>
        public static SwitchExperiment ForceTimesMass()
        {
            FluidParticle[] start = Column(0.0025f, new Vector3Int(6, 14, 6), out FluidSolverSettings settings);
            return One("force-mass", start, 0.35f, settings, (ref ThesisSwitches s) => s.ForceTimesMass = true);
        }

        /// <summary>6.3.3 lines 04 to 06: MaxVelocity taken for an acceleration is less than gravity.</summary>
        public static SwitchExperiment AccelerationLimit()
        {
            FluidParticle[] start = Column(0.025f, new Vector3Int(6, 14, 6), out FluidSolverSettings settings);
            return One("acceleration-limit", start, 0.6f, settings,
                (ref ThesisSwitches s) => s.AccelerationLimit = ThesisAccelerationLimit.AsPrinted);
        }

        /// <summary>6.3.4: a block falls for 0.4 s in steps of 20 ms; without the half kick it is ½ g t dt ahead.</summary>
        public static SwitchExperiment HalfKick()
        {
            FluidParticle[] start =
                Block(0.05f, new Vector3Int(5, 3, 5), new Vector3(0.6f, 1.4f, 0.6f), 0.55f, out FluidSolverSettings settings);
            settings.TimeStep = 0.02f;
            return One("half-kick", start, 0.4f, settings, (ref ThesisSwitches s) => s.HalfKick = false);
        }

        /// <summary>The whole text as printed: a column that breaks, at 10 mm, where force times mass has about the right size.</summary>
        public static SwitchExperiment AllPrinted()
        {
            FluidParticle[] start =
                Block(0.01f, new Vector3Int(10, 16, 8), new Vector3(0.32f, 0.24f, 0.08f), 0f, out FluidSolverSettings settings);
            for (int i = 0; i < start.Length; i++) start[i].Position += new Vector3(-0.11f, -0.04f, 0f);
            return new SwitchExperiment("printed", start, 0.25f, settings, settings.With(ThesisSwitches.Printed));
        }

        /// <summary>A cube of liquid that fills half of its box, for timing.</summary>
        /// <param name="side">Particles along an edge.</param>
        /// <param name="settings">Constants by rule.</param>
        /// <returns>The particles.</returns>
        public static FluidParticle[] Cube(int side, out FluidSolverSettings settings)
        {
            const float spacing = 0.025f;
            return Block(spacing, side * Vector3Int.one, spacing * side * new Vector3(1f, 2f, 1f), -0.5f * spacing * side, out settings);
        }

        private static SwitchExperiment One(string name, FluidParticle[] start, float seconds, in FluidSolverSettings settings,
            Change change)
        {
            ThesisSwitches switches = ThesisSwitches.Corrected;
            switches.PressureClamp = settings.PressureClamp;
            change(ref switches);
            FluidSolverSettings printed = settings.With(switches);
            return new SwitchExperiment(name, start, seconds, settings, printed);
        }

        // A lattice that fills the width of its box from the floor up to 0.8 of the height.
        private static FluidParticle[] Column(float spacing, Vector3Int counts, out FluidSolverSettings settings)
        {
            Vector3 domain = spacing * new Vector3(counts.x, counts.y * 1.25f, counts.z);
            return Block(spacing, counts, domain, 0.5f * (spacing * counts.y - domain.y), out settings);
        }

        // A lattice in a box, its centre at a height over the box's centre, with a jitter of 2 % where it will settle.
        private static FluidParticle[] Block(float spacing, Vector3Int counts, Vector3 domain, float height,
            out FluidSolverSettings settings)
        {
            var random = new System.Random(5);
            float jitter = height > 0f ? 0f : 0.02f * spacing;
            var particles = new FluidParticle[counts.x * counts.y * counts.z];
            for (int i = 0; i < particles.Length; i++)
            {
                var cell = new Vector3(i % counts.x - 0.5f * (counts.x - 1), i / counts.x % counts.y - 0.5f * (counts.y - 1),
                    i / (counts.x * counts.y) - 0.5f * (counts.z - 1));
                var offset = new Vector3((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f,
                    (float)random.NextDouble() - 0.5f);
                particles[i] = new FluidParticle(spacing * cell + 2f * jitter * offset + height * Vector3.up, Vector3.zero, (uint)i);
            }
            FluidRuleInput input = FluidRuleInput.ThesisWater;
            input.DomainSize = domain;
            input.Spacing = spacing;
            input.LiquidHeight = 0.5f * domain.y + height + 0.5f * counts.y * spacing;
            input.LiquidDepth = Math.Min(counts.y * spacing, input.LiquidHeight);
            settings = FluidRules.Derive(input);
            return particles;
        }
    }
}
