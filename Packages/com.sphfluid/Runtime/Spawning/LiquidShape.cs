using UnityEngine;

namespace SphFluid
{
    /// <summary>A body of liquid in simulation space, as the spawner needs it.</summary>
    internal abstract class LiquidShape
    {
        /// <summary>A shape that lies in the image of the unit cube.</summary>
        /// <param name="name">Name for messages.</param>
        /// <param name="frame">Maps the unit cube centred on the origin to a box round the shape [m].</param>
        /// <param name="velocity">Initial velocity in simulation space [m/s].</param>
        protected LiquidShape(string name, Matrix4x4 frame, Vector3 velocity)
        {
            Name = name;
            Frame = frame;
            Velocity = velocity;
        }

        public string Name { get; }
        public Vector3 Velocity { get; }

        /// <summary>Maps the unit cube centred on the origin to a box round the shape [m].</summary>
        public Matrix4x4 Frame { get; protected set; }

        /// <summary>Volume [m³].</summary>
        public abstract double Volume { get; }

        /// <summary>Axis-aligned bounds of <see cref="Frame"/> in simulation space.</summary>
        public Bounds Bounds => new Bounds(Frame.GetColumn(3), 2f * AffineMath.Extents(Frame, 0.5f * Vector3.one));

        /// <summary>Whether the point lies in the liquid.</summary>
        public abstract bool Contains(Vector3 point);

        /// <summary>Finds out which sites of a lattice are the shape's, where that depends on the lattice; called before any site is asked for.</summary>
        public virtual void Fit(in SpawnLattice lattice)
        {
        }

        /// <summary>The frame of axis-aligned bounds.</summary>
        protected static Matrix4x4 FrameOf(Bounds bounds) => Matrix4x4.TRS(bounds.center, Quaternion.identity, bounds.size);
    }
}
