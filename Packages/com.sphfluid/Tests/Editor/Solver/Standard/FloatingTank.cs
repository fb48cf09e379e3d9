using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A box in still water of a square tank without walls of its own; frames of 1/60 s.</summary>
    internal sealed class FloatingTank : IDisposable
    {
        public const double FrameTime = 1.0 / 60.0;

        private readonly FloatingRig rig;
        private readonly FluidSolverSettings settings;
        private readonly int particles, steps;
        private readonly float volume;

        /// <param name="spacing">Particle spacing [m].</param>
        /// <param name="across">Particles across the tank.</param>
        /// <param name="deep">Particles of its depth, half of its height.</param>
        /// <param name="size">Of the box [m].</param>
        /// <param name="ratio">Density of the box over the water's.</param>
        /// <param name="height">Of its centre above the water's level without it [m].</param>
        /// <param name="rotation">Of the box.</param>
        /// <param name="method">What computes the water.</param>
        public FloatingTank(float spacing, int across, int deep, Vector3 size, float ratio, float height, Quaternion rotation,
            FluidMethodKind method = FluidMethodKind.Standard)
        {
            var domain = new Vector3(across * spacing, 2 * deep * spacing, across * spacing);
            settings = BodyRig.Water(domain, spacing, deep * spacing, 0f, method);
            var centre = new Vector3(0f, height, 0f);
            Vector3 half = 0.5f * size + 0.5f * spacing * Vector3.one;
            FluidParticle[] block = FloatingRig.Block(new Vector3Int(across, deep, across), spacing, -0.5f * domain)
                .Where(p => Mathf.Abs(p.Position.x) > half.x || Mathf.Abs(p.Position.z) > half.z ||
                    Mathf.Abs(p.Position.y - centre.y) > half.y).ToArray();
            for (int i = 0; i < block.Length; i++) block[i].Id = (uint)i;
            particles = block.Length;
            steps = Mathf.CeilToInt((float)FrameTime / settings.TimeStep - 1e-4f);
            volume = size.x * size.y * size.z;
            Size = size;
            Ratio = ratio;
            rig = new FloatingRig(settings, block);
            Body = rig.AddBox(size, ratio * settings.RestDensity, centre, rotation);
        }

        public Vector3 Size { get; }
        public float Ratio { get; }
        public FloatingBody Body { get; }

        /// <summary>The body after each frame.</summary>
        public List<FloatingState> States { get; } = new List<FloatingState>();

        public FluidSolver Solver => rig.Solver;

        /// <summary>
        /// Level of the water with the box afloat in it, by its mass [m]: at rest particles are packed a fiftieth denser than on the
        /// lattice that they start from.
        /// </summary>
        public double Level
        {
            get
            {
                double liquid = particles * (double)settings.ParticleMass / settings.RestDensity + Math.Min(Ratio, 1f) * volume;
                return liquid / (settings.DomainSize.x * settings.DomainSize.z) - 0.5 * settings.DomainSize.y;
            }
        }

        /// <summary>
        /// Level of the water as it is seen [m]: half a spacing above the highest particles of columns two spacings wide, away from the
        /// box.
        /// </summary>
        public double SeenLevel
        {
            get
            {
                double width = 2.0 * settings.Spacing, away = 0.75 * Size.x;
                return rig.Particles().Where(p => Math.Max(Math.Abs(p.Position.x), Math.Abs(p.Position.z)) > away)
                    .GroupBy(p => (Math.Floor(p.Position.x / width), Math.Floor(p.Position.z / width)))
                    .Average(c => c.Max(p => p.Position.y)) + 0.5 * settings.Spacing;
            }
        }

        /// <summary>Buoyancy of the box under water [N].</summary>
        public double Buoyancy => settings.RestDensity * settings.Gravity.magnitude * volume;

        /// <summary>Nothing moves the box any more.</summary>
        public void Hold() => Body.Mass = new FloatingMass(float.PositiveInfinity, Vector3.positiveInfinity, Vector3.zero);

        public void Play(double seconds)
        {
            for (int frames = (int)Math.Round(seconds / FrameTime); frames > 0; frames--)
            {
                rig.Frame(steps);
                States.Add(rig.Read(Body));
            }
        }

        /// <summary>Mean of the last frames.</summary>
        public double Late(double seconds, Func<FloatingState, double> value) =>
            States.Skip(States.Count - (int)(seconds / FrameTime)).Average(value);

        /// <summary>Part of its height that the box is under water, over the last frames.</summary>
        public double Draught(double seconds) => (Level - Late(seconds, s => s.Centre.y) + 0.5 * Size.y) / Size.y;

        /// <summary>Root mean square of its vertical speed over the last frames [m/s].</summary>
        public double Speed(double seconds) => Math.Sqrt(Late(seconds, s => s.Velocity.y * s.Velocity.y));

        /// <summary>Angle of its own y axis from the vertical now [degrees].</summary>
        public double Tilt => Vector3.Angle(Vector3.up, States[States.Count - 1].Rotation * Vector3.up);

        public string Figures(double seconds)
        {
            FluidCounters counters = rig.Solver.ReadCountersNow();
            return $"{particles} particles, {steps} steps a frame of {settings.TimeStep:g3} s: draught {Draught(seconds):f4} of {Ratio}, " +
                $"{Draught(seconds) + (SeenLevel - Level) / Size.y:f4} below the level as it is seen, tilt {Tilt:f2} deg, late v_rms " +
                $"{Speed(seconds):g3} m/s, " +
                $"contacts {counters.Contacts}, squeezed {counters.Squeezed}, limits {counters.ImpulseLimits}, at " +
                $"{States[States.Count - 1].Centre}";
        }

        public void Dispose() => rig.Dispose();
    }
}
