using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A rectangle of a wall on which the force of the liquid is summed over every step, by pressure and by contact: that on a particle
    /// is spread over a spacing about its nearest point of the wall, up to the wall's edge. Made by <see cref="WallForces.Add"/>. Walls
    /// count that are within <see cref="Depth"/> of the rectangle and face as it does within 60°: faces of the domain and meshes, at rest
    /// or moving. On an edge of the wall what the faces round it push along the normal counts too.
    /// </summary>
    public sealed class WallPatch
    {
        private readonly TimeMean samples = new TimeMean();
        private (Vector3 Centre, Quaternion Rotation, Vector2 Size, object Carrier, int Solids) covered;

        internal WallPatch()
        {
        }

        /// <summary>Centre [m, simulation space].</summary>
        public Vector3 Centre { get; internal set; }

        /// <summary>Its axes: x and y are the edges, z is the normal, out of the wall towards the liquid.</summary>
        public Quaternion Rotation { get; internal set; } = Quaternion.identity;

        /// <summary>
        /// Edge lengths along its x and y axes [m]. Of a spacing or less it sees one particle or none; four spacings and more give a steady
        /// mean.
        /// </summary>
        public Vector2 Size { get; internal set; }

        /// <summary>How far before and behind it a wall belongs to it [m]: a spacing, unless it was given.</summary>
        public float Depth { get; internal set; }

        /// <summary>
        /// Area [m²]: of the part that lies on a wall, as the last steps found it; of all of it where the centre is on none.
        /// </summary>
        public double Area => Cover?.Area ?? RectangleArea;

        /// <summary>
        /// Impulse of the liquid on the wall since the patch was added, against its normal [N s]; negative where it pulls.
        /// </summary>
        public double Impulse { get; private set; }

        /// <summary>Time over which <see cref="Impulse"/> was summed [s].</summary>
        public double Seconds { get; private set; }

        /// <summary>Simulated time up to which the sums have arrived [s]; −1 while there are none.</summary>
        public double Time => samples.Time;

        /// <summary>Whether a sum has arrived.</summary>
        public bool HasValue => samples.Count > 0;

        /// <summary>
        /// How far back single samples are kept [simulated s], 1 by default: as long as the longest mean that is asked for.
        /// </summary>
        /// <exception cref="ArgumentException">It is negative or not finite.</exception>
        public double Memory { get => samples.Memory; set => samples.Memory = Require.NotNegative(value, nameof(value)); }


        /// <summary>
        /// The samples that are kept, oldest first: one a step, or one of several steps where a batch has more than
        /// <see cref="WallForces.MostParts"/>.
        /// </summary>
        public IEnumerable<WallSample> Samples
        {
            get
            {
                for (int i = 0; i < samples.Count; i++)
                {
                    yield return new WallSample(samples[i].Time, samples[i].Length, samples[i].Integral);
                }
            }
        }

        /// <summary>
        /// What it goes with in the motion of a frame, at whose end both are in place: the key of a collider's state; null: nothing.
        /// </summary>
        internal object Carrier { get; set; }

        /// <summary>Its part on a wall; null: not looked for yet.</summary>
        internal WallCover? Cover { get; private set; }

        /// <summary>Of all of it [m²].</summary>
        internal double RectangleArea => (double)Size.x * Size.y;

        /// <summary>Number of samples that have arrived since it was added.</summary>
        internal long Received { get; private set; }

        /// <summary>Mean force on the wall, against the normal [N].</summary>
        /// <param name="seconds">Simulated time before <see cref="Time"/> to take the mean of; at most <see cref="Memory"/>. 0: the last
        /// sample alone.</param>
        /// <returns>The force; 0 while no sum has arrived.</returns>
        /// <exception cref="ArgumentException">The time is negative or not finite.</exception>
        public double MeanForce(double seconds) => samples.Mean(Require.NotNegative(seconds, nameof(seconds)));


        /// <summary>Mean pressure on the wall: force per area [Pa].</summary>
        /// <param name="seconds">As of <see cref="MeanForce(double)"/>.</param>
        /// <returns>The pressure; 0 while no sum has arrived.</returns>
        public double MeanPressure(double seconds) => Area > 0.0 ? MeanForce(seconds) / Area : 0.0;

        /// <summary>The largest mean pressure that any of the last samples ended [Pa]: a hit lasts less than a frame.</summary>
        /// <param name="seconds">As of <see cref="MeanForce(double)"/>.</param>
        /// <param name="last">Number of samples, as many as there are at most.</param>
        internal double PeakPressure(double seconds, long last) => Area > 0.0 ? samples.Peak(seconds, last) / Area : 0.0;

        /// <summary>Forgets all sums: <see cref="Impulse"/> begins anew.</summary>
        public void Clear()
        {
            samples.Clear();
            Impulse = Seconds = 0.0;
        }

        /// <summary>Finds <see cref="Cover"/> anew where the rectangle is not as it was when it was found.</summary>
        /// <param name="place">Place and rotation on what carries it, size, what carries it, and the number of solids.</param>
        /// <param name="depth">How far before and behind it a wall belongs to it [m].</param>
        /// <param name="settings">The liquid's.</param>
        /// <param name="solids">What it collides with.</param>
        internal void FindCover((Vector3 Centre, Quaternion Rotation, Vector2 Size, object Carrier, int Solids) place,
            float depth, in FluidSolverSettings settings, IReadOnlyList<FluidObstacle> solids)
        {
            bool isKept = Cover.HasValue && place.Size == covered.Size && ReferenceEquals(place.Carrier, covered.Carrier) &&
                place.Solids == covered.Solids &&
                (place.Centre - covered.Centre).magnitude < 1e-3f * settings.Spacing &&
                Math.Abs(Quaternion.Dot(place.Rotation, covered.Rotation)) > 0.99999f;
            if (isKept) return;
            Cover = WallCover.Of(this, depth, settings, solids);
            covered = place;
        }

        internal void SetSample(in WallSample sample)
        {
            samples.Add(sample.Time, sample.Seconds, sample.Impulse);
            Impulse += sample.Impulse;
            Seconds += sample.Seconds;
            Received++;
        }
    }
}
