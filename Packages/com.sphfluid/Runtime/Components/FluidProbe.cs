using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Reads pressure on a wall, or velocity, density or pressure within a liquid. On a wall it finds the nearest one within the support
    /// radius and reads the force on a rectangle of it, of all steps, over its area: what a pressure gauge there would read. It goes with a
    /// wall that moves.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Probe")]
    [ManualPage("instruments", "fluid-probe")]
    public sealed class FluidProbe : FluidInstrument
    {
        private readonly WallPatchPlacing wall = new WallPatchPlacing();
        private readonly TimeMean[] means = { new TimeMean(), new TimeMean(), new TimeMean(), new TimeMean() };

        [SerializeField,
            Tooltip(
                "Wall Pressure: force of the liquid on a rectangle of the nearest wall, over its area, in Pa. Velocity: of the liquid at " +
                "this object, in m/s. " +
            "Density: in kg/m³. Liquid Pressure: mean pressure of the particles around, in Pa; it is noisy and not what a wall feels, so " +
            "average it, and keep it away from walls.")]
        private FluidProbeKind kind = FluidProbeKind.WallPressure;

        [SerializeField,
            Tooltip(
                "Edge lengths of the rectangle on the wall, in metres. Four particle spacings and more give a steady mean; one spacing " +
                "sees one particle or none. Wall Pressure only.")]
        private Vector2 patchSize = new Vector2(0.1f, 0.1f);

        private FluidProbeKind known;
        private FluidQuery query;
        private long answer, taken;

        /// <summary>What is read; a change begins anew.</summary>
        public FluidProbeKind Kind { get => Limits.Known(kind); set => kind = value; }

        /// <summary>Edge lengths of the rectangle on the wall [m], positive. Wall pressure only.</summary>
        public Vector2 PatchSize { get => patchSize; set => patchSize = value; }

        /// <summary>Mean velocity of the liquid here [m/s], in the world; 0 where it is dry and of other kinds.</summary>
        public Vector3 Velocity => Kind != FluidProbeKind.Velocity || !HasValue ? Vector3.zero
            : new Vector3((float)means[1].Mean(AveragingTime), (float)means[2].Mean(AveragingTime), (float)means[3].Mean(AveragingTime));

        /// <summary>
        /// The largest mean over <see cref="FluidInstrument.AveragingTime"/> that ended at any step since
        /// <see cref="FluidInstrument.Clear"/> [Pa]; a hit lasts less than a frame. Wall pressure only.
        /// </summary>
        public float Peak { get; private set; }

        /// <summary>Mean force on the rectangle [N]. Wall pressure only.</summary>
        public float Force => Kind == FluidProbeKind.WallPressure && wall.Patch != null ? (float)wall.Patch.MeanForce(AveragingTime) : 0f;

        /// <summary>The sums of all steps on the rectangle; null while there is no wall, and of other kinds.</summary>
        public WallPatch Patch => wall.Patch;

        /// <summary>World position of the rectangle on the wall [m]; this object's own while there is no wall.</summary>
        public Vector3 WallPoint => wall.IsPlaced ? wall.WorldPoint : transform.position;

        /// <summary>
        /// World rotation of the rectangle: x and y axes along its edges, z out of the wall; this object's own while there is no wall.
        /// </summary>
        public Quaternion WallRotation => wall.IsPlaced ? wall.WorldRotation : transform.rotation;

        /// <inheritdoc/>
        public override IReadOnlyList<FluidReading> Readings
        {
            get
            {
                double Of(double value) => HasValue ? value : double.NaN;
                switch (Kind)
                {
                    case FluidProbeKind.Velocity:
                        Vector3 v = Velocity;
                        return new[]
                        {
                            new FluidReading("speed_m_s", "m/s", Of(MainValue)), new FluidReading("velocity_x_m_s", "m/s", Of(v.x)),
                            new FluidReading("velocity_y_m_s", "m/s", Of(v.y)), new FluidReading("velocity_z_m_s", "m/s", Of(v.z)),
                        };
                    case FluidProbeKind.Density:
                        return new[] { new FluidReading("density_kg_m3", "kg/m³", Of(MainValue)) };
                    case FluidProbeKind.LiquidPressure:
                        return new[] { new FluidReading("liquid_pressure_pa", "Pa", Of(MainValue)) };
                    default:
                        return new[] { new FluidReading("pressure_pa", "Pa", Of(MainValue)),
                            new FluidReading("peak_pressure_pa", "Pa", Of(Peak)), new FluidReading("force_n", "N", Of(Force)) };
                }
            }
        }

        /// <inheritdoc/>
        private protected override double MainValue => Kind == FluidProbeKind.WallPressure ? wall.Patch?.MeanPressure(AveragingTime) ?? 0.0
            : Kind == FluidProbeKind.Velocity ? Velocity.magnitude : means[0].Mean(AveragingTime);

        /// <inheritdoc/>
        public override void Clear()
        {
            base.Clear();
            foreach (TimeMean mean in means) mean.Clear();
            wall.Patch?.Clear();
            Peak = 0f;
            answer = 0;
        }

        private protected override FluidMessage? Ask(FluidSimulation liquid)
        {
            if (Kind != known)
            {
                Leave(liquid);
                Clear();
                known = Kind;
            }
            return Kind == FluidProbeKind.WallPressure ? AskWall(liquid) : AskPoint(liquid);
        }

        private FluidMessage? AskPoint(FluidSimulation liquid)
        {
            if (query.Equals(default)) query = liquid.Queries.AddPoint(transform.position);
            else liquid.Queries.Move(query, transform.position);
            Vector3 place = DomainSpace.FromWorld(liquid.transform.position, liquid.transform.rotation)
                .MultiplyPoint3x4(transform.position);
            return DomainSpace.Holds(place, liquid.DomainSize) ? (FluidMessage?)null
                : Warn($"It is outside of the domain of '{liquid.name}', where there is no liquid.",
                    "Move it into the domain, or assign another Simulation.");
        }

        private FluidMessage? AskWall(FluidSimulation liquid)
        {
            FluidSolver solver = liquid.Solver;
            if (liquid.IsPlayedBack)
            {
                wall.Leave();
                return Warn("The liquid is played back and not computed, so there is no wall pressure to read.",
                    "Set Kind to Liquid Pressure, which is noisy.");
            }
            if (!solver.MeasuresWallForces)
            {
                return Warn($"The method {solver.Kind} does not sum the force on walls, so there is no wall pressure to read.",
                    $"Set the simulation's Method to {FluidMethodKind.Standard}, or Kind to Liquid Pressure, which is noisy.");
            }
            if (solver.WallForcesShortfall is string shortfall)
            {
                return Warn(shortfall, "Set Kind to Liquid Pressure, which is noisy, or use another graphics device or API.");
            }
            if (!(patchSize.x > 0f && patchSize.y > 0f && AffineMath.IsFinite(patchSize)))
            {
                wall.Leave();
                return Warn($"A rectangle of {patchSize.x} by {patchSize.y} m has no area to read a force on.",
                    "Give Patch Size two positive edge lengths.");
            }
            if (!wall.TryPlace(liquid, transform, patchSize, out bool isFull))
            {
                return isFull
                    ? Warn($"'{liquid.name}' has {WallForces.Most} wall patches already, the most that it may have.",
                        "Disable another probe.")
                    : Warn(
                        FormattableString.Invariant($"No wall of '{liquid.name}' is within {solver.Settings.SupportRadius:0.###} m, so ") +
                        "there is no wall pressure to read.",
                        "Move this object to a face of the domain or to a collider in it, or set Kind to Liquid Pressure.");
            }
            wall.Patch.Memory = AveragingTime + 0.5;
            float smallest = Mathf.Min(patchSize.x, patchSize.y), spacing = solver.Settings.Spacing;
            return smallest >= 0.999f * spacing ? (FluidMessage?)null
                : Warn(
                    FormattableString.Invariant($"Its patch is {smallest:0.####} m wide, less than a particle spacing of ") +
                    FormattableString.Invariant($"{spacing:0.####} m, so it mostly sees one particle or none."),
                    "Raise Patch Size to four spacings or more, or lower the simulation's Particle Spacing.");
        }

        private protected override double Measure(FluidSimulation liquid) => Kind == FluidProbeKind.WallPressure ? TakeWall()
            : TakePoint(liquid);

        private double TakeWall()
        {
            WallPatch patch = wall.Patch;
            if (patch == null || patch.Received == taken || !patch.HasValue) return -1.0;
            Peak = Mathf.Max(Peak, (float)patch.PeakPressure(AveragingTime, patch.Received - taken));
            taken = patch.Received;
            return patch.Time;
        }

        private double TakePoint(FluidSimulation liquid)
        {
            FluidQueries all = liquid.Queries;
            if (all.Answer == answer || !all.TryGet(query, out FluidPointResult point)) return -1.0;
            answer = all.Answer;
            double time = all.AnsweredTime, span = means[0].Count > 0 ? time - means[0].Time : 1e-6;
            if (!(span > 0.0)) return -1.0;
            Vector3 v = point.IsWet ? point.Velocity : Vector3.zero;
            Add(0, Kind == FluidProbeKind.Density ? point.Density : point.Pressure);
            for (int axis = 0; axis < 3; axis++) Add(axis + 1, v[axis]);
            return time;

            void Add(int mean, double value)
            {
                means[mean].Memory = AveragingTime + 0.1;
                means[mean].Add(time, span, span * value);
            }
        }

        private protected override void Leave(FluidSimulation liquid)
        {
            liquid.Queries.Remove(query);
            query = default;
            wall.Leave();
            taken = 0;
        }
    }
}
