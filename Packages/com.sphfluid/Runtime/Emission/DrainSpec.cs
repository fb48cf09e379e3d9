using UnityEngine;

namespace SphFluid
{
    /// <summary>What a drain is, as of one moment.</summary>
    internal struct DrainSpec
    {
        /// <summary>The component: the context of messages.</summary>
        public Component Owner;

        /// <summary>What outlives the moment; the run writes into it.</summary>
        public DrainState State;

        /// <summary>Maps the cube from −1 to 1, or a capsule of radius 1 along y, to the world [m].</summary>
        public Matrix4x4 Frame;

        /// <summary>Whether it is a box; else a capsule, or with <see cref="Length"/> 0 a sphere.</summary>
        public bool IsBox;

        /// <summary>Half the distance of the centres of a capsule's ends, over its radius.</summary>
        public float Length;

        /// <summary>Whether its object has a collider of a kind that is no drain, so that the box serves.</summary>
        public bool IgnoresCollider;

        /// <summary>The zone in simulation space.</summary>
        public readonly DrainZone Zone(in DomainPose worldToSimulation)
        {
            Matrix4x4 frame = worldToSimulation * Frame;
            return IsBox ? DrainZone.Box(frame) : DrainZone.Capsule(frame, Length);
        }
    }

    /// <summary>A drain at work: what it took.</summary>
    internal sealed class DrainState
    {
        /// <summary>The run that counts for it; another begins anew.</summary>
        public object Run;

        /// <summary>Volume since the liquid's start, as of a few frames ago [m³].</summary>
        public double Drained;

        /// <summary>Of this, before the source that counts now.</summary>
        public double Before;
    }
}
