using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Events;

namespace SphFluid
{
    /// <summary>
    /// Reads a liquid at this object's place, or its level on a line from there, and raises events when the reading crosses a threshold.
    /// The readings are <see cref="FluidQueries"/>: nothing waits for the GPU, so they are some frames old.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Sensor")]
    [ManualPage("scripting", "fluid-sensor")]
    public sealed class FluidSensor : MonoBehaviour
    {
        /// <summary>An event with the reading.</summary>
        [Serializable]
        public sealed class ReadingEvent : UnityEvent<float>
        {
        }

        [SerializeField,
            Tooltip(
                "What is read. Wetness: 1 within the liquid, 0.5 at its surface, 0 outside. Speed in m/s. Pressure in Pa. Level: height " +
                "of the surface " +
            "above this object along its up axis, in metres. Fill Level: part of a box about this object that holds liquid, 0 to 1. " +
            "Flow: volume per second through a " +
            "rectangle about this object along its forward axis, in m³/s.")]
        private FluidSensorKind kind = FluidSensorKind.Wetness;

        [SerializeField, Unit("m"), Min(0f),
            Tooltip("How far above this object, along its up axis, to look for the level, in metres. Level only.")]
        private float length = 1f;

        [SerializeField, Unit("m"),
            Tooltip(
                "Edge lengths of the box along this object's axes, in metres, or of the rectangle along the first two. Fill Level and " +
                "Flow only.")]
        private Vector3 size = new Vector3(0.2f, 0.2f, 0.2f);

        [SerializeField, Unit("s"), Min(0f),
            Tooltip(
                "Time over which the reading is averaged, in simulated seconds. 0: not at all. Pressure needs about 0.1, Flow about 0.5.")]
        private float averagingTime;

        [SerializeField, Tooltip("The events tell when the reading crosses this, in the unit of the reading.")]
        private float threshold = 0.5f;

        [SerializeField, Min(0f),
            Tooltip(
                "How far the reading has to go from one event to the other, half of it on each side of the threshold, so that a noisy " +
                "reading raises no events.")]
        private float hysteresis = 0.2f;

        [SerializeField,
            Tooltip(
                "Simulation that is read. Empty: the simulation among this object's parents, else the only one in the scene, else the " +
                "one whose domain holds this object.")]
        private FluidSimulation simulation;

        [SerializeField, Tooltip("Raised with the reading when it has risen above the threshold. The first reading raises none.")]
        private ReadingEvent roseAbove = new ReadingEvent();

        [SerializeField, Tooltip("Raised with the reading when it has fallen below the threshold.")]
        private ReadingEvent fellBelow = new ReadingEvent();

        private FluidQuery shape; // the box or the rectangle
        private double flowed, flowedTime; // at the answer before; NaN: none
        private readonly LineReading reading = new LineReading();
        private SensorSwitch state;
        private FluidSimulation read; // whose queries these are
        private FluidSensorKind known;
        private long answer;
        private double answeredTime;

        /// <summary>What is read; a change begins anew.</summary>
        public FluidSensorKind Kind { get => Limits.Known(kind); set => kind = value; }

        /// <summary>How far above this object, along its up axis, the level is looked for [m]; 0 or more.</summary>
        public float Length { get => Limits.Clamp(length, 0f); set => length = value; }

        /// <summary>
        /// Edge lengths of the box of <see cref="FluidSensorKind.FillLevel"/> along this object's axes [m], or of the rectangle of
        /// <see cref="FluidSensorKind.Flow"/>
        /// along the first two, 0 or more; without positive ones there is no reading.
        /// </summary>
        public Vector3 Size { get => Limits.NotNegative(size); set => size = value; }

        /// <summary>Time constant of the mean [simulated s], 0 or more; 0: none.</summary>
        public float AveragingTime { get => Limits.Clamp(averagingTime, 0f); set => averagingTime = value; }

        /// <summary>What the events are about, in the unit of the reading. Not a number counts as 0.</summary>
        public float Threshold { get => Limits.Finite(threshold); set => threshold = value; }

        /// <summary>
        /// How far the reading has to go from one event to the other, in its unit, 0 or more; half of it on each side of the threshold.
        /// </summary>
        public float Hysteresis { get => Limits.Clamp(hysteresis, 0f); set => hysteresis = value; }

        /// <summary>Simulation that is read; null: found as the tooltip says.</summary>
        public FluidSimulation Simulation { get => simulation; set => simulation = value; }

        /// <summary>Raised with the reading when it has risen above the threshold. The first reading raises none.</summary>
        public ReadingEvent RoseAbove => roseAbove;

        /// <summary>Raised with the reading when it has fallen below the threshold.</summary>
        public ReadingEvent FellBelow => fellBelow;

        /// <summary>Whether there is a reading: the liquid runs, and an answer has come.</summary>
        public bool HasValue { get; private set; }

        /// <summary>The reading, in the unit of its <see cref="Kind"/>; 0 while there is none.</summary>
        public float Value { get; private set; }

        /// <summary>Whether the reading is above the threshold, by the last event; false while there is none.</summary>
        public bool IsAbove => HasValue && state.IsAbove;

        /// <summary>Simulated time of the reading [s]; -1 while there is none.</summary>
        public double AnsweredTime => HasValue ? answeredTime : -1.0;

        private void Update()
        {
            FluidSimulation owner = FluidScene.Owner(this, simulation, FluidSimulation.Active);
            if (owner != read || Kind != known) Begin(owner);
            if (read == null || !read.IsRunning || !IsPlaced)
            {
                Forget();
                return;
            }
            if (Kind == FluidSensorKind.FillLevel || Kind == FluidSensorKind.Flow)
            {
                PlaceShape();
                if (read.Queries.Answer == answer) return;
                if (read.Queries.TryGetBox(shape, out FluidBoxResult held)) SetReading(held.Fill);
                if (read.Queries.TryGetPatch(shape, out FluidPatchResult passed))
                {
                    TakeFlow((double)passed.Particles * passed.ParticleVolume);
                }
                return;
            }
            SensorLine line = Line();
            reading.Place(read.Queries, line, transform.position, transform.up);
            if (read.Queries.Answer != answer) SetReading(line);
        }

        private void OnDisable() => Begin(null);

        private bool IsPlaced
        {
            get
            {
                Vector3 place = transform.position + transform.up;
                float sum = place.x + place.y + place.z;
                bool isOpen = Size.x > 0f && Size.y > 0f;
                bool holds = Kind == FluidSensorKind.FillLevel ? isOpen && Size.z > 0f : Kind != FluidSensorKind.Flow || isOpen;
                return holds && !float.IsNaN(sum) && !float.IsInfinity(sum);
            }
        }

        private void Begin(FluidSimulation owner)
        {
            if (read is object) reading.Remove(read.Queries);
            if (read is object) read.Queries.Remove(shape);
            shape = default;
            read = owner;
            known = Kind;
            Forget();
        }

        private void Forget()
        {
            HasValue = false;
            Value = 0f;
            answer = 0;
            flowed = double.NaN;
            state.Reset();
        }

        private SensorLine Line()
        {
            if (Kind != FluidSensorKind.Level) return SensorLine.Point;
            DomainPose toSimulation = DomainSpace.FromWorld(read.transform.position, read.transform.rotation);
            return SensorLine.Create(toSimulation.MultiplyPoint3x4(transform.position), toSimulation.MultiplyVector(transform.up), Length,
                read.DomainSize,
                read.Solver.Settings.Spacing);
        }

        private void PlaceShape()
        {
            FluidQueries all = read.Queries;
            Vector3 place = transform.position;
            Quaternion turn = transform.rotation;
            bool isNew = shape.Equals(default), isBox = Kind == FluidSensorKind.FillLevel;
            if (isNew) shape = isBox ? all.AddBox(place, Size, turn) : all.AddPatch(place, (Vector2)Size, turn);
            else if (isBox) all.Move(shape, place, Size, turn);
            else all.Move(shape, place, (Vector2)Size, turn);
        }

        private void TakeFlow(double volume)
        {
            double time = read.Queries.AnsweredTime, before = flowed, passed = time - flowedTime;
            if (passed <= 0.0 && !double.IsNaN(before)) return;
            (flowed, flowedTime) = (volume, time);
            if (!double.IsNaN(before)) SetReading((float)((volume - before) / passed));
        }

        private void SetReading(in SensorLine line)
        {
            if (!(reading.Densities(read.Queries, out FluidPointResult point) is IReadOnlyList<float> densities)) return;
            float restDensity = read.Solver.Settings.RestDensity;
            SetReading(Kind == FluidSensorKind.Level ? line.Level(densities, restDensity)
                : Kind == FluidSensorKind.Speed ? point.IsWet ? point.Velocity.magnitude : 0f
                : Kind == FluidSensorKind.Pressure ? point.Pressure
                : point.Density / restDensity);
        }

        private void SetReading(float now)
        {
            FluidQueries all = read.Queries;
            double passed = Math.Max(0.0, all.AnsweredTime - answeredTime);
            double share = HasValue && AveragingTime > 0f ? 1.0 - Math.Exp(-passed / AveragingTime) : 1.0;
            Value += (float)share * (now - Value);
            (HasValue, answer, answeredTime) = (true, all.Answer, all.AnsweredTime);
            int crossed = state.Update(Value, Threshold, Hysteresis);
            if (crossed > 0) roseAbove.Invoke(Value);
            else if (crossed < 0) fellBelow.Invoke(Value);
        }
    }
}
