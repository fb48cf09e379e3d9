using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Keeps a <see cref="WallPatch"/> on the wall that is nearest to an object, and with that wall when it moves.</summary>
    internal sealed class WallPatchPlacing
    {
        private WallForces forces;
        private Transform carrier; // of the wall: its collider's or the domain's
        private object key;
        private Matrix4x4 inCarrier; // the object's pose when the wall was looked for
        private Vector3 point;       // of the wall, in the carrier
        private Quaternion rotation;
        private Vector2 size;
        private long colliderChanges;

        /// <summary>The patch; null while there is no wall.</summary>
        public WallPatch Patch { get; private set; }

        /// <summary>Whether it is on a wall.</summary>
        public bool IsPlaced => Patch != null && carrier != null;

        /// <summary>Its centre in the world [m].</summary>
        public Vector3 WorldPoint => carrier.position + carrier.rotation * point;

        /// <summary>Its axes in the world: z out of the wall.</summary>
        public Quaternion WorldRotation => carrier.rotation * rotation;

        /// <summary>Puts the patch on the nearest wall; once a frame before the steps.</summary>
        /// <param name="liquid">A liquid that runs by a method that sums the force on walls.</param>
        /// <param name="probe">The object; its up axis decides how the patch turns in the wall.</param>
        /// <param name="patchSize">Edge lengths [m].</param>
        /// <param name="isFull">Whether there is a wall, but the liquid has as many patches as it may have.</param>
        /// <returns>Whether there is a patch on a wall.</returns>
        public bool TryPlace(FluidSimulation liquid, Transform probe, Vector2 patchSize, out bool isFull)
        {
            isFull = false;
            if (NeedsSearch(liquid, probe) && !Search(liquid, probe))
            {
                Leave();
                return false;
            }
            DomainPose toSimulation = DomainSpace.FromWorld(liquid.transform.position, liquid.transform.rotation);
            Vector3 centre = toSimulation.MultiplyPoint3x4(WorldPoint);
            Quaternion turn = (Quaternion.Inverse(liquid.transform.rotation) * carrier.rotation * rotation).normalized;
            if (Patch == null)
            {
                if (liquid.Solver.WallForces.Patches.Count >= WallForces.Most)
                {
                    isFull = true;
                    return false;
                }
                forces = liquid.Solver.WallForces;
                Patch = forces.Add(centre, turn, patchSize);
            }
            else if (!centre.Equals(Patch.Centre) || !turn.Equals(Patch.Rotation) || patchSize != size)
            {
                if (patchSize != size) Patch.Clear(); // another area
                forces.Move(Patch, centre, turn, patchSize);
            }
            size = patchSize;
            Patch.Carrier = key;
            return true;
        }

        /// <summary>Ends the patch.</summary>
        public void Leave()
        {
            if (Patch != null) forces.Remove(Patch);
            Patch = null;
            carrier = null;
        }

        // While the object keeps its place on the wall that it has, it keeps the wall.
        private bool NeedsSearch(FluidSimulation liquid, Transform probe)
        {
            if (carrier == null || Patch == null) return true;
            Matrix4x4 now = Relative(probe);
            float shift = 0f;
            for (int i = 0; i < 16; i++) shift = Math.Max(shift, Math.Abs(now[i] - inCarrier[i]));
            bool scene = liquid.Collision.Changes != colliderChanges && key == null; // something may stand before a face now
            return shift > 1e-3f * liquid.Solver.Settings.Spacing || scene;
        }

        private Matrix4x4 Relative(Transform probe)
        {
            Quaternion back = Quaternion.Inverse(carrier.rotation);
            return Matrix4x4.TRS(back * (probe.position - carrier.position), back * probe.rotation, Vector3.one);
        }

        private bool Search(FluidSimulation liquid, Transform probe)
        {
            Transform domain = liquid.transform;
            DomainPose toSimulation = DomainSpace.FromWorld(domain.position, domain.rotation);
            WallPlace? found = WallFinder.Find(liquid.Collision.Solids, liquid.Solver.Settings,
                toSimulation.MultiplyPoint3x4(probe.position), toSimulation.MultiplyVector(probe.forward));
            colliderChanges = liquid.Collision.Changes;
            if (!(found is WallPlace place)) return false;
            object before = key;
            key = place.Obstacle?.State.Key;
            carrier = place.Obstacle?.Source != null ? place.Obstacle.Source.transform : domain;
            if (!ReferenceEquals(before, key)) Patch?.Clear(); // another wall
            Quaternion back = Quaternion.Inverse(carrier.rotation);
            Vector3 normal = domain.rotation * place.Normal, up = Vector3.ProjectOnPlane(probe.up, normal);
            if (up.magnitude < 0.1f) up = Vector3.ProjectOnPlane(probe.right, normal);
            point = back * (domain.position + domain.rotation * place.Point - carrier.position);
            rotation = back * Quaternion.LookRotation(normal, up);
            inCarrier = Relative(probe);
            return true;
        }
    }
}
