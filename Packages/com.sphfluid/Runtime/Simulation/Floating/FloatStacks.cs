using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Bodies that rest on each other. What holds them together only the scene's physics knows, and the GPU hears of it some frames late;
    /// until then the liquid would throw a raft against its load as if it bore none. So the GPU takes them for one rigid body while they
    /// touch and move as one.
    /// </summary>
    internal sealed class FloatStacks
    {
        // Between bodies that move as one [m/s].
        private const float MostSlip = 0.05f;

        // To the places of two convex colliders that are nearest to each other.
        private const int Nearings = 8;

        private readonly float touch;
        private readonly List<(Bounds box, int number)> boxes = new List<(Bounds, int)>();
        private readonly List<List<RigidbodyFloat>> stacks = new List<List<RigidbodyFloat>>();
        private int[] firsts = Array.Empty<int>(); // by body: the first one of its stack

        /// <param name="touch">Bodies that are nearer touch [m].</param>
        public FloatStacks(float touch)
        {
            this.touch = touch;
        }

        /// <summary>Forgets what rests on what.</summary>
        public void Clear() => stacks.Clear();

        /// <summary>
        /// Finds what rests on what, puts bodies that rest on each other to sleep or wakes them together, and tells how the liquid moves
        /// each with its stack.
        /// </summary>
        /// <param name="floats">The bodies as they are now.</param>
        public void Find(IReadOnlyList<RigidbodyFloat> floats)
        {
            Join(floats);
            stacks.Clear();
            for (int i = 0; i < floats.Count; i++)
            {
                floats[i].StandAlone();
                if (firsts[i] == i) continue;
                RigidbodyFloat first = floats[firsts[i]];
                List<RigidbodyFloat> members = stacks.Find(s => s[0] == first);
                if (members == null) stacks.Add(members = new List<RigidbodyFloat> { first });
                members.Add(floats[i]);
            }

            stacks.RemoveAll(Sleep);
            for (int s = 0; s < stacks.Count; s++) Share(stacks[s], s + 1);
            foreach (RigidbodyFloat known in floats)
                if (known.Body.Stack == 0 && known.IsCalm && !known.IsAsleep) known.Sleep();
        }

        /// <summary>
        /// Before a step of physics: corrections move a stack as a whole, since how bodies lie on each other physics knows, and the GPU's
        /// bodies follow it.
        /// </summary>
        public void Correct()
        {
            foreach (List<RigidbodyFloat> members in stacks)
            {
                FloatSum velocity = new FloatSum(members[0].Motion.Pose.Centre), place = velocity;
                foreach (RigidbodyFloat member in members)
                {
                    velocity.Add(member.Mass, member.Motion.Pose, member.Correction.Velocity, member.Correction.AngularVelocity);
                    place.Add(member.Mass, member.Motion.Pose, member.Correction.Displacement, member.Correction.Rotation);
                }

                foreach (RigidbodyFloat member in members)
                {
                    Vector3 centre = member.Motion.Pose.Centre;
                    member.Apply(new FloatChange
                    {
                        Velocity = velocity.At(centre, out Vector3 spin), AngularVelocity = spin,
                        Displacement = place.At(centre, out Vector3 turn), Rotation = turn,
                    });
                }
            }
        }

        // Along x: of two that touch neither begins behind the other's end.
        private void Join(IReadOnlyList<RigidbodyFloat> floats)
        {
            if (firsts.Length < floats.Count) firsts = new int[Mathf.NextPowerOfTwo(floats.Count)];
            boxes.Clear();
            for (int i = 0; i < floats.Count; i++)
            {
                firsts[i] = i;
                Bounds box = floats[i].Colliders[0].bounds;
                foreach (Collider collider in floats[i].Colliders) box.Encapsulate(collider.bounds);
                box.Expand(touch);
                boxes.Add((box, i));
            }

            boxes.Sort((a, b) => a.box.min.x.CompareTo(b.box.min.x));
            for (int a = 0; a < boxes.Count; a++)
                for (int b = a + 1; b < boxes.Count && boxes[b].box.min.x <= boxes[a].box.max.x; b++)
                    if (boxes[a].box.Intersects(boxes[b].box) && IsHeld(floats[boxes[a].number], floats[boxes[b].number]))
                    {
                        Join(boxes[a].number, boxes[b].number, floats.Count);
                    }
        }

        private void Join(int a, int b, int count)
        {
            int first = Math.Min(firsts[a], firsts[b]), other = Math.Max(firsts[a], firsts[b]);
            for (int i = 0; i < count; i++)
                if (firsts[i] == other) firsts[i] = first;
        }

        private bool IsHeld(RigidbodyFloat a, RigidbodyFloat b)
        {
            if (!a.IsFree || !b.IsFree) return false;
            Vector3 between = b.Motion.Pose.Centre - a.Motion.Pose.Centre, spin = b.Motion.AngularVelocity - a.Motion.AngularVelocity;
            Vector3 slip = b.Motion.Velocity - a.Motion.Velocity - Vector3.Cross(a.Motion.AngularVelocity, between);
            if (slip.magnitude > MostSlip || spin.magnitude * between.magnitude > MostSlip) return false;
            foreach (Collider own in a.Colliders)
                foreach (Collider other in b.Colliders)
                    if (Touch(own, other)) return true;
            return false;
        }

        // From one to the other and back, to the places that are nearest to each other.
        private bool Touch(Collider a, Collider b)
        {
            if (!IsConvex(a) || !IsConvex(b)) return false;
            Vector3 here = a.ClosestPoint(b.bounds.center);
            for (int i = 0; i < Nearings; i++)
            {
                Vector3 there = b.ClosestPoint(here);
                if ((there - here).magnitude < touch) return true;
                here = a.ClosestPoint(there);
            }

            return false;
        }

        // Unity finds the closest point of these only.
        private static bool IsConvex(Collider collider) =>
            collider is BoxCollider || collider is SphereCollider || collider is CapsuleCollider ||
                collider is MeshCollider mesh && mesh.convex;

        // All or none.
        private static bool Sleep(List<RigidbodyFloat> members)
        {
            bool sleep = members.TrueForAll(m => m.IsAsleep || m.IsCalm);
            foreach (RigidbodyFloat member in members)
            {
                if (sleep && !member.IsAsleep) member.Sleep();
                else if (!sleep && member.IsAsleep) member.Wake();
            }

            return sleep;
        }

        // What turns it is taken about where the GPU has it: about a stack that leans in the meantime, the lift of the raft would turn it
        // over.
        private static void Share(List<RigidbodyFloat> members, int stack)
        {
            FloatSum own = new FloatSum(members[0].Motion.Pose.Centre), there = own;
            foreach (RigidbodyFloat member in members)
            {
                own.Add(member.Mass, member.Motion.Pose, member.Pull.Velocity, member.Pull.AngularVelocity);
                there.Add(member.Mass, member.Body.KnownFrame < 0 ? member.Motion.Pose : member.Body.Known.Pose, member.Pull.Velocity,
                    member.Pull.AngularVelocity);
            }

            FloatSum whole = own;
            whole.Torque = there.Torque;
            foreach (RigidbodyFloat member in members)
            {
                Vector3 centre = member.Motion.Pose.Centre;
                var share = new FloatChange { Velocity = whole.At(centre, out Vector3 turn), AngularVelocity = turn };
                var spread = new FloatChange
                {
                    Velocity = member.Pull.Velocity - own.At(centre, out turn),
                    AngularVelocity = member.Pull.AngularVelocity - turn
                };
                member.Stand(stack, own.Mass, share, spread);
            }
        }
    }
}
