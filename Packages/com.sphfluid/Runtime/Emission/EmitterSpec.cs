using UnityEngine;

namespace SphFluid
{
    /// <summary>What an emitter is, as of one moment.</summary>
    internal struct EmitterSpec
    {
        /// <summary>The component: the context of messages.</summary>
        public Component Owner;

        /// <summary>What outlives the moment; the run writes into it.</summary>
        public EmitterState State;

        /// <summary>What is to flow; null: what the simulation holds.</summary>
        public Object Liquid;

        /// <summary>World position of the nozzle's centre [m].</summary>
        public Vector3 Position;

        /// <summary>World rotation; liquid leaves along its z axis.</summary>
        public Quaternion Rotation;

        public FluidEmitterShape Shape;

        /// <summary>Edge lengths of the nozzle [m].</summary>
        public Vector2 Size;

        /// <summary>The nozzle's mesh, of <see cref="FluidEmitterShape.Mesh"/>.</summary>
        public Mesh Mesh;

        /// <summary>Scale of the mesh along the emitter's axes.</summary>
        public Vector3 Scale;

        public FluidEmitterFlow Flow;

        /// <summary>Speed [m/s] or volume rate [m³/s], by <see cref="Flow"/>.</summary>
        public float Amount;

        /// <summary>Time that its liquid stays [s]; 0: for ever.</summary>
        public float Lifetime;

        /// <summary>Whether it stands in liquid, and drives what it gives through a pipe.</summary>
        public bool UnderWater;

        /// <summary>Area of the nozzle [m²] at a particle spacing [m].</summary>
        public readonly double Area(float spacing) => Shape switch
        {
            FluidEmitterShape.Disc => System.Math.PI / 4.0 * Size.x * Size.y,
            FluidEmitterShape.Line => (double)Size.x * spacing,
            FluidEmitterShape.Mesh => EmitterOutline.Create(this, spacing).Places.Length * ((double)spacing * spacing),
            _ => (double)Size.x * Size.y,
        };

        /// <summary>Speed at the nozzle [m/s].</summary>
        public readonly double Speed(float spacing)
        {
            if (Flow == FluidEmitterFlow.Speed) return Amount;
            double area = Area(spacing);
            return area > 0.0 ? Amount / area : 0.0;
        }

        /// <summary>The owner's name.</summary>
        public readonly string Name => Owner.name;
    }

    /// <summary>An emitter at work: whether it is on, and what it gave.</summary>
    internal sealed class EmitterState
    {
        /// <summary>Whether it emits.</summary>
        public bool IsOn;

        /// <summary>Volume after which it stops [m³].</summary>
        public double VolumeLeft = double.PositiveInfinity;

        /// <summary>Time after which it stops [s].</summary>
        public double TimeLeft = double.PositiveInfinity;

        /// <summary>Its pipe, where it was needed last.</summary>
        public EmitterPipe Pipe;

        /// <summary>What is seen of its mesh, where it was needed last.</summary>
        public EmitterOutline Outline;

        /// <summary>Velocity of the nozzle in the last frame with steps, simulation space [m/s].</summary>
        public Vector3 Carried;

        /// <summary>The run that counts for it; another begins anew.</summary>
        public object Run;

        /// <summary>Volumes since the liquid's start, as of a few frames ago [m³].</summary>
        public double Emitted, Blocked, Refused;

        /// <summary>Of these, before the source that counts now.</summary>
        public double EmittedBefore, BlockedBefore, RefusedBefore;

        /// <summary>Writes whether and how long it emits, and what it gave before.</summary>
        public void Save(SaveWriter writer)
        {
            writer.Write(IsOn);
            writer.Write(Carried);
            foreach (double value in new[] { VolumeLeft, TimeLeft, EmittedBefore, BlockedBefore, RefusedBefore }) writer.Write(value);
        }

        /// <summary>Goes on from a save.</summary>
        public void Load(SaveReader reader)
        {
            IsOn = reader.Read<bool>();
            Carried = reader.Read<Vector3>();
            (VolumeLeft, TimeLeft) = (reader.Read<double>(), reader.Read<double>());
            (EmittedBefore, BlockedBefore, RefusedBefore) = (reader.Read<double>(), reader.Read<double>(), reader.Read<double>());
        }
    }
}
