using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// An emitter in a running liquid. Its particles are a lattice that moves with the liquid: layers leave the nozzle at the times at
    /// which the one before has gone the distance of layers, wherever frames and steps begin and end. A change of the speed acts from the
    /// next layer on.
    /// </summary>
    internal sealed class EmitterRun
    {
        private EmitterSpec shape;
        private EmitterSites sites;
        private EmitterOutline outline; // null of other shapes than a mesh
        private double next = double.NegativeInfinity;
        private Vector3 position;
        private Quaternion rotation;
        private bool hasPose;

        public EmitterRun(int source) => Source = source;

        /// <summary>Number of the source.</summary>
        public int Source { get; }

        /// <summary>Whether the emitter is there in the present frame.</summary>
        public bool IsUsed { get; set; }

        /// <summary>Particles of a layer; 0 before the first.</summary>
        public int Sites => sites?.Places.Length ?? 0;

        /// <summary>Whether it was reported that liquid is in the way, or that there are no slots.</summary>
        public bool ReportedBlocked { get; set; }

        /// <summary>Queues the layers that leave the nozzle in a frame.</summary>
        /// <param name="emitter">The emitter at the end of the frame.</param>
        /// <param name="spec">The simulation.</param>
        /// <param name="begin">Simulated time at which the frame begins [s].</param>
        /// <param name="end">And ends.</param>
        /// <param name="births">Receives the particles.</param>
        /// <param name="lifetimes">Receives when they leave, where they do.</param>
        public void Emit(in EmitterSpec emitter, in FluidSpec spec, double begin, double end, BirthQueue births,
            ParticleLifetimes lifetimes)
        {
            Vector3 newPosition = spec.WorldToLocal.MultiplyPoint3x4(emitter.Position);
            Quaternion newRotation = Quaternion.Inverse(spec.Rotation) * emitter.Rotation;
            if (!hasPose) (position, rotation, hasPose) = (newPosition, newRotation, true);
            if (sites == null || !IsSame(emitter, shape) || !HasOutline(emitter, spec.Spacing))
            {
                sites = EmitterSites.For(emitter, spec.Spacing);
                shape = emitter;
                outline = Outline(emitter, spec.Spacing);
            }

            EmitterState state = emitter.State;
            float speed = (float)emitter.Speed(spec.Spacing);
            Vector3 carried = end > begin ? (newPosition - position) / (float)(end - begin) : Vector3.zero;
            double layer = sites.Places.Length * System.Math.Pow(spec.Spacing, 3);
            next = System.Math.Max(next, begin);
            while (state.IsOn && speed > 0f && next < end)
            {
                float part = (float)((next - begin) / (end - begin));
                Quaternion turn = Quaternion.Slerp(rotation, newRotation, part);
                Vector3 centre = Vector3.Lerp(position, newPosition, part);
                Vector3 velocity = turn * new Vector3(0f, 0f, speed) + carried;
                uint first = births.NextId;
                foreach (Vector3 place in sites.Places) births.Add(centre + turn * place, velocity, next, Source, emitter.UnderWater);
                if (emitter.Lifetime > 0f) lifetimes.Add(first, unchecked(births.NextId - first), next + emitter.Lifetime);
                double period = sites.LayerDistance / speed;
                next += period;
                state.VolumeLeft -= layer;
                state.TimeLeft -= period;
                state.IsOn = state.VolumeLeft > 0.5 * layer && state.TimeLeft > 1e-3 * period;
            }
            if (end > begin) state.Carried = carried;
            if (end > begin) (position, rotation) = (newPosition, newRotation); // else what it went belongs to the next steps
        }

        /// <summary>Writes when and where the next layer leaves.</summary>
        public void Save(SaveWriter writer)
        {
            writer.Write(Source);
            writer.Write(ReportedBlocked);
            writer.Write(next);
            writer.Write(position);
            writer.Write(rotation);
            writer.Write(hasPose);
        }

        /// <summary>Reads what <see cref="Save"/> wrote.</summary>
        public static EmitterRun Load(SaveReader reader) => new EmitterRun(reader.Read<int>())
        {
            ReportedBlocked = reader.Read<bool>(),
            next = reader.Read<double>(),
            position = reader.Read<Vector3>(),
            rotation = reader.Read<Quaternion>(),
            hasPose = reader.Read<bool>(),
        };

        private bool HasOutline(in EmitterSpec emitter, float spacing) => ReferenceEquals(outline, Outline(emitter, spacing));

        private static EmitterOutline Outline(in EmitterSpec emitter, float spacing) =>
            emitter.Shape == FluidEmitterShape.Mesh ? EmitterOutline.Create(emitter, spacing) : null;

        private static bool IsSame(in EmitterSpec a, in EmitterSpec b) => a.Shape == b.Shape && a.Size.Equals(b.Size);
    }
}
