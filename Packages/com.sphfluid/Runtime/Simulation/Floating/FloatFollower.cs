using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Where a body is and how it moves, in simulation space.</summary>
    internal struct FloatMotion
    {
        public FloatingPose Pose;
        public Vector3 Velocity;
        public Vector3 AngularVelocity;
    }

    /// <summary>What is added to a body at once [m/s, rad/s, m, rad].</summary>
    internal struct FloatChange
    {
        public Vector3 Velocity;
        public Vector3 AngularVelocity;
        public Vector3 Displacement;
        public Vector3 Rotation;
    }

    /// <summary>
    /// Brings a body of the scene's physics to where the GPU has it, known some frames late: a part of the gap a frame, less what was given
    /// since. The GPU's body feels none of it, so nothing that is late acts back on it.
    /// </summary>
    internal sealed class FloatFollower
    {
        /// <summary>Frames that are remembered: read-backs that are older do not count.</summary>
        public const int Memory = 32;

        // Of the gap, free and where something refuses corrections: they hold the GPU's body off then, and nothing is seen of them.
        private const float Gain = 0.25f, HeldGain = 0.5f;

        private readonly Entry[] entries = new Entry[Memory];
        private FloatChange given;
        private long newest = -1, oldest;

        private struct Entry
        {
            public FloatMotion Motion;
            public FloatChange Given; // between the frame before and this one
            public double Begin, Time, Acted; // Begin: of what was given; Acted: for how long
        }

        /// <summary>Forgets all frames: the body was put elsewhere.</summary>
        public void Restart()
        {
            newest = -1;
            given = default;
        }

        /// <summary>Remembers the scene's body at a frame with steps, after the corrections since the last one.</summary>
        /// <param name="frame">Number of the frame, one more each time.</param>
        /// <param name="time">The liquid's time at its end [s].</param>
        /// <param name="motion">The body.</param>
        /// <param name="acted">Time that physics was stepped since the last one [s].</param>
        /// <param name="lead">How much later the liquid's time is than the last of these steps [s].</param>
        public void Record(long frame, double time, in FloatMotion motion, double acted, double lead = 0.0)
        {
            if (newest < 0) oldest = frame;
            newest = frame;
            entries[frame % Memory] = new Entry { Motion = motion, Given = given, Begin = time - lead - acted, Time = time, Acted = acted };
            given = default;
        }

        /// <summary>Writes what is remembered.</summary>
        public void Save(SaveWriter writer)
        {
            writer.WriteItems(entries, Memory);
            writer.Write(given);
            writer.Write(newest);
            writer.Write(oldest);
        }

        /// <summary>Goes on from a save.</summary>
        public void Load(SaveReader reader)
        {
            System.Array.Copy(reader.ReadItems<Entry>(), entries, Memory);
            given = reader.Read<FloatChange>();
            newest = reader.Read<long>();
            oldest = reader.Read<long>();
        }

        /// <summary>What to give the scene's body now.</summary>
        /// <param name="gpu">The body on the GPU.</param>
        /// <param name="frame">Frame that this is of.</param>
        /// <param name="rates">Accelerations that both are taken to have had since [m/s², rad/s²].</param>
        /// <param name="mostTurn">Most that the body may be turned [rad].</param>
        /// <param name="held">Whether something refuses what the scene's body is given, so that it has not fallen as the GPU's
        /// would.</param>
        /// <returns>Nothing, where the frame is not remembered.</returns>
        public FloatChange Correct(in FloatMotion gpu, long frame, in FloatChange rates = default, float mostTurn = float.PositiveInfinity,
            bool held = false)
        {
            if (newest < 0 || frame < oldest || frame > newest || newest - frame >= Memory) return default;
            Entry then = entries[frame % Memory];
            double now = entries[newest % Memory].Time;
            float since = (float)(now - then.Time);
            Vector3 hastened = since * rates.Velocity, turning = since * rates.AngularVelocity;
            double fall = held ? 0.0 : 0.5 * since * since; // [s²]
            for (long j = frame + 1; held && j <= newest; j++) fall += (now - entries[j % Memory].Begin) * entries[j % Memory].Acted;
            var gap = new FloatChange
            {
                Velocity = gpu.Velocity - then.Motion.Velocity + hastened,
                AngularVelocity = gpu.AngularVelocity - then.Motion.AngularVelocity + turning,
            };
            gap.Displacement = gpu.Pose.Centre - then.Motion.Pose.Centre + since * (gap.Velocity - hastened) + (float)fall * rates.Velocity;
            gap.Rotation = gpu.Pose.TurnFrom(then.Motion.Pose) + since * (gap.AngularVelocity - turning) +
                (float)fall * rates.AngularVelocity;
            for (long j = frame + 1; j <= newest; j++)
            {
                Subtract(ref gap, entries[j % Memory].Given, (float)(now - entries[j % Memory].Begin));
            }
            Subtract(ref gap, given, 0f);
            float gain = held ? HeldGain : Gain;
            return new FloatChange
            {
                Velocity = gain * gap.Velocity,
                AngularVelocity = gain * gap.AngularVelocity,
                Displacement = gain * gap.Displacement,
                Rotation = Vector3.ClampMagnitude(gain * gap.Rotation, mostTurn),
            };
        }

        /// <summary>The scene's body was given that, by gravity and the liquid's force too.</summary>
        public void Give(in FloatChange change)
        {
            given.Velocity += change.Velocity;
            given.AngularVelocity += change.AngularVelocity;
            given.Displacement += change.Displacement;
            given.Rotation += change.Rotation;
        }

        private static void Subtract(ref FloatChange gap, in FloatChange earlier, float age)
        {
            gap.Velocity -= earlier.Velocity;
            gap.AngularVelocity -= earlier.AngularVelocity;
            gap.Displacement -= earlier.Displacement + age * earlier.Velocity;
            gap.Rotation -= earlier.Rotation + age * earlier.AngularVelocity;
        }
    }
}
