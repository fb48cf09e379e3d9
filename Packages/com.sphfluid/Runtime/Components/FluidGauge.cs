using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Height of a liquid along a line from this object's place along its up axis, as a wave gauge reads it: that of the surface of the
    /// lowest liquid on the line, where the density is half the rest density.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Gauge")]
    [ManualPage("instruments", "fluid-gauge")]
    public sealed class FluidGauge : FluidInstrument
    {
        private readonly LineReading reading = new LineReading();
        private readonly TimeMean heights = new TimeMean();
        private readonly FluidReading[] readings = new FluidReading[1];

        [SerializeField, Min(0f), Tooltip("How far above this object, along its up axis, to look for the surface, in metres.")]
        private float length = 1f;

        private long answer;

        /// <summary>How far above this object, along its up axis, the surface is looked for [m]; 0 or more.</summary>
        public float Length { get => Limits.Clamp(length, 0f); set => length = value; }

        /// <summary>
        /// Mean height of the surface over this object along its up axis [m]: 0 without liquid, the line's upper end where liquid reaches
        /// it.
        /// </summary>
        public float Height => Value;

        /// <summary>World position of the surface [m]; this object's while there is no reading.</summary>
        public Vector3 Surface => transform.position + Height * transform.up;

        /// <inheritdoc/>
        public override IReadOnlyList<FluidReading> Readings
        {
            get
            {
                readings[0] = new FluidReading("height_m", "m", HasValue ? MainValue : double.NaN);
                return readings;
            }
        }

        /// <inheritdoc/>
        private protected override double MainValue => heights.Mean(AveragingTime);

        /// <inheritdoc/>
        public override void Clear()
        {
            base.Clear();
            heights.Clear();
            answer = 0;
        }

        private protected override FluidMessage? Ask(FluidSimulation liquid)
        {
            SensorLine line = Line(liquid);
            reading.Place(liquid.Queries, line, transform.position, transform.up);
            return line.Step > 0f ? (FluidMessage?)null
                : Warn("Its line does not go through the domain, so it reads 0.",
                    "Move this object below the liquid, turn its up axis upwards, or raise Length.");
        }

        private protected override double Measure(FluidSimulation liquid)
        {
            FluidQueries all = liquid.Queries;
            if (all.Answer == answer || !(reading.Densities(all, out _) is IReadOnlyList<float> densities)) return -1.0;
            double time = all.AnsweredTime, span = heights.Count > 0 ? time - heights.Time : 1e-6;
            answer = all.Answer;
            if (!(span > 0.0)) return -1.0;
            heights.Memory = AveragingTime + 0.1;
            heights.Add(time, span, span * Line(liquid).Level(densities, liquid.Solver.Settings.RestDensity));
            return time;
        }

        private protected override void Leave(FluidSimulation liquid) => reading.Remove(liquid.Queries);

        private SensorLine Line(FluidSimulation liquid)
        {
            DomainPose toSimulation = DomainSpace.FromWorld(liquid.transform.position, liquid.transform.rotation);
            return SensorLine.Create(toSimulation.MultiplyPoint3x4(transform.position), toSimulation.MultiplyVector(transform.up), Length,
                liquid.DomainSize,
                liquid.Solver.Settings.Spacing);
        }
    }
}
