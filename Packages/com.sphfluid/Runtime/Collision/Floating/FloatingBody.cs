using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A rigid body that the liquid moves, as its owner sees it: the GPU integrates it within the steps. Whatever else moves it, the owner
    /// says as pushes; where it was put elsewhere, as a seed.
    /// </summary>
    internal sealed class FloatingBody
    {
        private Vector3 pushVelocity, pushAngularVelocity, pushDisplacement, pushRotation;
        private bool seeds = true, isNamed;

        /// <summary>A body at rest at a place.</summary>
        public FloatingBody(in FloatingMass mass, in FloatingPose pose)
        {
            Mass = mass;
            Pose = pose;
        }

        /// <summary>How it answers to impulses.</summary>
        public FloatingMass Mass { get; set; }

        /// <summary>Where its owner has it now: its colliders are seen in this frame.</summary>
        public FloatingPose Pose { get; set; }

        /// <summary>Velocity of the centre of mass that its owner has now [m/s].</summary>
        public Vector3 Velocity { get; set; }

        /// <summary>Angular velocity that its owner has now [rad/s].</summary>
        public Vector3 AngularVelocity { get; set; }

        /// <summary>Number of the stack of bodies with which it moves as one; 0: it moves alone.</summary>
        public int Stack { get; set; }

        /// <summary>Mass of that stack [kg].</summary>
        public float StackMass { get; set; }

        /// <summary>Number of its last seed, unlike that of any other body's; 0 before the first frame.</summary>
        public uint Epoch { get; private set; }

        /// <summary>The body on the GPU as of the newest read-back, if there is one since the last seed.</summary>
        public FloatingState Known { get; private set; }

        /// <summary>Frame with steps that <see cref="Known"/> is of; −1: none since the last seed.</summary>
        public long KnownFrame { get; private set; } = -1;

        /// <summary>Whether steps were taken since the last seed, and no read-back of them was taken.</summary>
        public bool IsAwaited => !seeds && KnownFrame < 0;

        /// <summary>Whether a message about the body is the first.</summary>
        public bool TryName() => !isNamed && (isNamed = true);

        /// <summary>With the next steps the GPU's body begins anew where its owner has it.</summary>
        public void Seed()
        {
            seeds = true;
            KnownFrame = -1;
            ForgetPushes();
        }

        /// <summary>Adds what others than the liquid and gravity changed; spread over the next steps.</summary>
        public void Push(Vector3 velocity, Vector3 angularVelocity, Vector3 displacement, Vector3 rotation)
        {
            pushVelocity += velocity;
            pushAngularVelocity += angularVelocity;
            pushDisplacement += displacement;
            pushRotation += rotation;
        }

        /// <summary>Writes what the next steps are given and what is known.</summary>
        public void Save(SaveWriter writer)
        {
            writer.WriteItems(new[] { pushVelocity, pushAngularVelocity, pushDisplacement, pushRotation, Velocity, AngularVelocity }, 6);
            writer.Write(seeds);
            writer.Write(Mass);
            writer.Write(Epoch);
            writer.Write(Known);
            writer.Write(KnownFrame);
        }

        /// <summary>Goes on from a save.</summary>
        public void Load(SaveReader reader)
        {
            Vector3[] vectors = reader.ReadItems<Vector3>();
            (pushVelocity, pushAngularVelocity, pushDisplacement) = (vectors[0], vectors[1], vectors[2]);
            (pushRotation, Velocity, AngularVelocity) = (vectors[3], vectors[4], vectors[5]);
            seeds = reader.Read<bool>();
            Mass = reader.Read<FloatingMass>();
            Epoch = reader.Read<uint>();
            Known = reader.Read<FloatingState>();
            KnownFrame = reader.Read<long>();
        }

        /// <summary>What the next steps are given.</summary>
        /// <param name="seed">Number of a seed, if there is one.</param>
        internal FloatingInput Input(uint seed)
        {
            if (seeds) Epoch = seed;
            return new FloatingInput
            {
                Rotation = Pose.Rotation,
                Centre = Pose.Centre,
                Velocity = Velocity,
                AngularVelocity = AngularVelocity,
                Epoch = Epoch,
                Flags = seeds ? FloatingInput.Seeds : 0u,
                InverseMass = Mass.InverseMass,
                InverseInertia = Mass.InverseInertia,
                Gravity = Mass.Gravity,
                Damping = Mass.Damping,
                AngularDamping = Mass.AngularDamping,
                FreeX = Mass.FreeX,
                FreeY = Mass.FreeY,
                FreeZ = Mass.FreeZ,
                PushVelocity = pushVelocity,
                PushAngularVelocity = pushAngularVelocity,
                PushDisplacement = pushDisplacement,
                PushRotation = pushRotation,
            };
        }

        /// <summary>The input was stepped through.</summary>
        internal void Arrive()
        {
            seeds = false;
            ForgetPushes();
        }

        /// <summary>Takes a read-back, unless it is of before the last seed.</summary>
        internal void Receive(in FloatingState state, long frame)
        {
            if (seeds || state.Epoch != Epoch) return;
            Known = state;
            KnownFrame = frame;
        }

        private void ForgetPushes() => pushVelocity = pushAngularVelocity = pushDisplacement = pushRotation = Vector3.zero;
    }
}
