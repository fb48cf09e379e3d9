using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Volume of liquid that goes through a rectangle about this object along its forward axis, a second and in total. Every particle that
    /// crosses between two frames counts, so nothing is lost; what goes back is taken off.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Flux")]
    [ManualPage("instruments", "fluid-flux")]
    public sealed class FluidFlux : FluidInstrument
    {
        private readonly TimeMean rates = new TimeMean();
        private readonly FluidReading[] readings = new FluidReading[2];

        [SerializeField, Tooltip("Edge lengths of the rectangle along this object's x and y axes, in metres.")]
        private Vector2 size = new Vector2(0.2f, 0.2f);

        private FluidQuery query;
        private long answer;
        private int counted; // at the answer before
        private double countedTime;
        private bool hasCount;

        /// <summary>Edge lengths of the rectangle along this object's x and y axes [m], positive.</summary>
        public Vector2 Size { get => size; set => size = value; }

        /// <summary>
        /// Mean volume a second along the forward axis [m³/s]. A particle is a spacing cubed of volume, so a short mean trembles.
        /// </summary>
        public float Rate => Value;

        /// <summary>Volume since the first reading, along the forward axis [m³].</summary>
        public double Total { get; private set; }

        /// <inheritdoc/>
        public override IReadOnlyList<FluidReading> Readings
        {
            get
            {
                readings[0] = new FluidReading("flow_m3_s", "m³/s", HasValue ? MainValue : double.NaN);
                readings[1] = new FluidReading("volume_m3", "m³", HasValue ? Total : double.NaN);
                return readings;
            }
        }

        /// <inheritdoc/>
        private protected override double MainValue => rates.Mean(AveragingTime);

        /// <inheritdoc/>
        public override void Clear()
        {
            base.Clear();
            rates.Clear();
            Total = 0.0;
            answer = 0;
            hasCount = false;
        }

        private protected override FluidMessage? Ask(FluidSimulation liquid)
        {
            FluidQueries all = liquid.Queries;
            if (!(size.x > 0f && size.y > 0f && AffineMath.IsFinite(size)))
            {
                Leave(liquid);
                return Warn($"Nothing goes through a rectangle of {size.x} by {size.y} m.", "Give Size two positive edge lengths.");
            }
            if (query.Equals(default)) query = all.AddPatch(transform.position, size, transform.rotation);
            else all.Move(query, transform.position, size, transform.rotation);
            Vector3 place = DomainSpace.FromWorld(liquid.transform.position, liquid.transform.rotation)
                .MultiplyPoint3x4(transform.position);
            return DomainSpace.Holds(place, liquid.DomainSize + new Vector3(size.magnitude, size.magnitude, size.magnitude))
                ? (FluidMessage?)null
                : Warn($"It is outside of the domain of '{liquid.name}', where there is no liquid.",
                    "Move it into the domain, or assign another Simulation.");
        }

        private protected override double Measure(FluidSimulation liquid)
        {
            FluidQueries all = liquid.Queries;
            if (query.Equals(default) || all.Answer == answer || !all.TryGetPatch(query, out FluidPatchResult passed)) return -1.0;
            answer = all.Answer;
            double time = all.AnsweredTime, span = time - countedTime;
            if (hasCount && span <= 0.0) return -1.0;
            double volume = hasCount ? (double)unchecked(passed.Particles - counted) * passed.ParticleVolume : 0.0;
            bool isFirst = !hasCount;
            (hasCount, counted, countedTime) = (true, passed.Particles, time);
            if (isFirst) return -1.0; // a flow needs two
            Total += volume;
            rates.Memory = AveragingTime + 0.1;
            rates.Add(time, span, volume);
            return time;
        }

        private protected override void Leave(FluidSimulation liquid)
        {
            liquid.Queries.Remove(query);
            query = default;
            hasCount = false;
        }
    }
}
