using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The rigid bodies that the liquid moves: a number each while they are there, their states and sums on the GPU.</summary>
    internal sealed class FloatingBodies : IDisposable
    {
        /// <summary>Most bodies at once: BODY_NUMBER_BITS in Shaders/Collision/FloatingBodies.hlsl.</summary>
        public const int Most = 1023;

        private const int Words = 12; // IMPULSE_WORDS

        private static readonly int InputsId = Shader.PropertyToID("_FloatingInputs");
        private static readonly int PartsId = Shader.PropertyToID("_FloatingParts");
        private static readonly int StatesId = Shader.PropertyToID("_FloatingStates");
        private static readonly int StatesOutId = Shader.PropertyToID("_FloatingStatesOut");
        private static readonly int SumsId = Shader.PropertyToID("_ImpulseSums");
        private static readonly int CountId = Shader.PropertyToID("_FloatingCount");
        private static readonly int ImpulseUnitId = Shader.PropertyToID("_ImpulseUnit");
        private static readonly int AngularUnitId = Shader.PropertyToID("_AngularUnit");
        private static readonly int ImpulseUnitsId = Shader.PropertyToID("_ImpulseUnits");
        private static readonly int AngularUnitsId = Shader.PropertyToID("_AngularUnits");
        private static readonly int ParticleMassId = Shader.PropertyToID("_ParticleMass");

        private readonly float impulseUnit, angularUnit, particleMass, tolerance;
        private readonly FloatingSize least;
        private readonly List<FloatingBody> slots = new List<FloatingBody>();
        private readonly List<BodyMotion> attached = new List<BodyMotion>();
        private readonly Dictionary<BodyMotion, (FloatingPart part, Bounds box)> rests =
            new Dictionary<BodyMotion, (FloatingPart, Bounds)>();
        private readonly Dictionary<int, int> joined = new Dictionary<int, int>(); // by stack: number of its first body
        private readonly List<FluidMessage> messages = new List<FluidMessage>();
        private readonly HashSet<FloatingBody> present = new HashSet<FloatingBody>();
        private FloatingInput[] inputs = Array.Empty<FloatingInput>();
        private FloatingPart[] parts = Array.Empty<FloatingPart>();
        private GraphicsBuffer inputBuffer, partBuffer, stateBuffer, sumBuffer;
        private uint epoch;

        /// <summary>None yet; nothing of any size is held.</summary>
        /// <param name="settings">The liquid's.</param>
        public FloatingBodies(in FluidSolverSettings settings)
        {
            least = new FloatingSize(settings);
            particleMass = settings.ParticleMass;
            tolerance = 1e-3f * settings.Spacing;
            impulseUnit = PowerOfTwo(particleMass * Math.Max(settings.SoundSpeed, settings.MaxSpeed)) / (1 << 26);
            angularUnit = impulseUnit * 2f * PowerOfTwo(settings.DomainSize.magnitude);
        }

        /// <summary>Numbers in use: a thread each.</summary>
        public int Count => slots.Count;

        /// <summary>What the bodies' owners are given of their states.</summary>
        public FloatingReadback Readback { get; } = new FloatingReadback();

        /// <summary>The bodies by number less one; null where a number is free.</summary>
        public IReadOnlyList<FloatingBody> Bodies => slots;

        /// <summary>Frames with steps since the start.</summary>
        public long Frame { get; private set; }

        /// <summary>Whether the next dispatch is the first of a frame.</summary>
        public bool Begins { get; set; }

        /// <summary>Whether bodies move as one.</summary>
        public bool Joins => joined.Count > 0;

        /// <summary>Bodies that found no number.</summary>
        public int LeftOut { get; private set; }

        /// <summary>Those that came with the last update and are smaller or lighter than the liquid can move them well.</summary>
        public IReadOnlyList<FluidMessage> Messages => messages;

        /// <summary>Bytes of the GPU buffers.</summary>
        public long Bytes => GpuBuffers.Size(inputBuffer, partBuffer, stateBuffer, sumBuffer);

        /// <summary>The number that a body's planes have, 0 for a body that nothing moves but its owner.</summary>
        public uint NumberOf(FloatingBody body) => body == null ? 0u : (uint)(slots.IndexOf(body) + 1);

        /// <summary>Whether a body has a collider that takes part: one whose colliders were all left out has no state.</summary>
        public bool Has(FloatingBody body) => present.Contains(body);

        /// <summary>Takes over the bodies of the frame.</summary>
        /// <param name="motions">Of the collision bodies, in their order; null for those at rest.</param>
        public void Update(IReadOnlyList<BodyMotion> motions)
        {
            messages.Clear();
            if (!Find(motions)) return;
            Readback.Deliver(slots, Frame);
            if (slots.Count == 0) return;
            Place(motions);
            Upload();
            Begins = true;
        }

        /// <summary>A frame's steps were recorded.</summary>
        public void Arrive()
        {
            if (slots.Count == 0) return;
            Frame++;
            foreach (FloatingBody body in slots) body?.Arrive();
        }

        /// <summary>Asks for the states at the end of a frame, when its steps have been given to the GPU.</summary>
        public void Request()
        {
            if (slots.Count > 0) Readback.Request(stateBuffer, slots.Count, Frame - 1);
        }

        /// <summary>Waits for the GPU and reads a body; for tools and tests.</summary>
        public FloatingState ReadNow(FloatingBody body) => ReadNow()[slots.IndexOf(body)];

        /// <summary>Waits for the GPU and reads all bodies; those of free numbers are of no meaning.</summary>
        public FloatingState[] ReadNow()
        {
            var states = new FloatingState[slots.Count];
            stateBuffer?.GetData(states, 0, 0, states.Length);
            return states;
        }

        /// <summary>Writes the bodies with their states and what they were given since the last step, waiting for the GPU.</summary>
        /// <param name="writer">The save.</param>
        /// <param name="keyOf">What a body is found again by.</param>
        public void Save(SaveWriter writer, Func<FloatingBody, string> keyOf)
        {
            writer.Write(epoch);
            writer.Write(Frame);
            writer.Write(slots.Count);
            foreach (FloatingBody body in slots) writer.WriteText(body == null ? "" : keyOf(body));
            var sums = new uint[Words * slots.Count];
            sumBuffer?.GetData(sums, 0, 0, sums.Length);
            writer.WriteItems(ReadNow(), slots.Count);
            writer.WriteItems(sums, sums.Length);
            Readback.Save(writer);
        }

        /// <summary>Goes on from a save.</summary>
        /// <param name="reader">The save.</param>
        /// <param name="present">What the scene has, by key.</param>
        /// <param name="bodyOf">The body of one of these.</param>
        public void Load<T>(SaveReader reader, IReadOnlyDictionary<string, T> present, Func<T, FloatingBody> bodyOf)
        {
            epoch = reader.Read<uint>();
            Frame = reader.Read<long>();
            slots.Clear();
            rests.Clear();
            for (int left = reader.Read<int>(); left > 0; left--) slots.Add(reader.TryFind(present, out T owner) ? bodyOf(owner) : null);
            FloatingState[] states = reader.ReadItems<FloatingState>();
            uint[] sums = reader.ReadItems<uint>();
            Readback.Load(reader);
            if (slots.Count == 0) return;
            RequireStates();
            stateBuffer.SetData(states);
            sumBuffer.SetData(sums);
        }

        /// <summary>Records the globals of Shaders/Collision/BodyImpulses.hlsl.</summary>
        public void SetImpulses(CommandBuffer cmd, ComputeKernel kernel)
        {
            kernel.SetFloat(cmd, ImpulseUnitsId, 1f / impulseUnit);
            kernel.SetFloat(cmd, AngularUnitsId, 1f / angularUnit);
            kernel.SetFloat(cmd, ParticleMassId, particleMass);
            kernel.SetBuffer(cmd, StatesId, stateBuffer);
            kernel.SetBuffer(cmd, SumsId, sumBuffer);
        }

        /// <summary>Records what MoveBodies reads and writes.</summary>
        public void SetMotion(CommandBuffer cmd, ComputeKernel kernel)
        {
            kernel.SetInt(cmd, CountId, slots.Count);
            kernel.SetFloat(cmd, ImpulseUnitId, impulseUnit);
            kernel.SetFloat(cmd, AngularUnitId, angularUnit);
            kernel.SetBuffer(cmd, InputsId, inputBuffer);
            kernel.SetBuffer(cmd, PartsId, partBuffer);
            kernel.SetBuffer(cmd, StatesOutId, stateBuffer);
            kernel.SetBuffer(cmd, SumsId, sumBuffer);
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            GpuBuffers.Dispose(ref inputBuffer);
            GpuBuffers.Dispose(ref partBuffer);
            GpuBuffers.Dispose(ref stateBuffer);
            GpuBuffers.Dispose(ref sumBuffer);
        }

        // Whether there are any, or were.
        private bool Find(IReadOnlyList<BodyMotion> motions)
        {
            bool had = slots.Count > 0;
            present.Clear();
            LeftOut = 0;
            for (int i = 0; i < motions.Count; i++)
                if (motions[i]?.Floats is FloatingBody body) present.Add(body);
            for (int s = 0; s < slots.Count; s++)
                if (slots[s] != null && !present.Contains(slots[s])) slots[s] = null;
            while (slots.Count > 0 && slots[slots.Count - 1] == null) slots.RemoveAt(slots.Count - 1);
            for (int i = 0; i < motions.Count; i++)
            {
                if (!(motions[i]?.Floats is FloatingBody body) || slots.Contains(body)) continue;
                int free = slots.IndexOf(null);
                if (free >= 0) slots[free] = body;
                else if (slots.Count < Most) slots.Add(body);
                else LeftOut++;
                body.Seed();
            }

            return had || slots.Count > 0;
        }

        // What a collider's own frame is in that of its body does not change, but for rounding, which must not move it.
        private void Place(IReadOnlyList<BodyMotion> motions)
        {
            attached.Clear();
            if (parts.Length < motions.Count) parts = new FloatingPart[motions.Count];
            if (inputs.Length < slots.Count) inputs = new FloatingInput[Mathf.NextPowerOfTwo(slots.Count)];
            uint first = 0;
            for (int s = 0; s < slots.Count; s++)
            {
                if (slots[s] == null)
                {
                    inputs[s] = default;
                    continue;
                }

                inputs[s] = slots[s].Input(++epoch);
                inputs[s].FirstPart = first;
                Bounds? box = null;
                Component source = null;
                for (int i = 0; i < motions.Count; i++)
                {
                    if (motions[i]?.Floats != slots[s]) continue;
                    (FloatingPart part, Bounds own) = Rest(motions[i], slots[s].Pose);
                    if (box is Bounds known) own.Encapsulate(known);
                    (box, source) = (own, source != null ? source : motions[i].Source);
                    parts[first] = part;
                    parts[first++].Body = (uint)i;
                    attached.Add(motions[i]);
                }

                inputs[s].PartCount = first - inputs[s].FirstPart;
                if (least.Bound(ref inputs[s], (box ?? default).size, slots[s].Stack == 0 ? slots[s].Mass.Mass : slots[s].StackMass) &&
                    slots[s].TryName())
                {
                    messages.Add(least.Message(source, (box ?? default).size, slots[s].Mass.Mass));
                }
            }

            if (rests.Count > attached.Count) Forget();
            Join();
        }

        // From the last to the first, each with the number of the next.
        private void Join()
        {
            joined.Clear();
            for (int s = slots.Count - 1; s >= 0; s--)
            {
                if (slots[s] == null || slots[s].Stack == 0) continue;
                joined.TryGetValue(slots[s].Stack, out int next);
                inputs[s].Next = (uint)next;
                inputs[s].Flags |= FloatingInput.Joined;
                joined[slots[s].Stack] = s + 1;
            }

            foreach (int first in joined.Values) inputs[first - 1].Flags |= FloatingInput.Leads;
        }

        private (FloatingPart part, Bounds box) Rest(BodyMotion motion, in FloatingPose pose)
        {
            var now = new FloatingPart { Rotation = pose.ToBody(motion.Rotation1), Position = pose.ToBody(motion.Position1) };
            if (rests.TryGetValue(motion, out (FloatingPart part, Bounds box) before) && IsNear(before.part, now)) return before;
            return rests[motion] = (now, BoxOf(motion.Mesh, now));
        }

        // In the frame of the body.
        private static Bounds BoxOf(TriangleMesh mesh, in FloatingPart part)
        {
            var box = new Bounds(part.Rotation * mesh.Vertices[mesh.Indices[0]] + part.Position, Vector3.zero);
            foreach (int index in mesh.Indices) box.Encapsulate(part.Rotation * mesh.Vertices[index] + part.Position);
            return box;
        }

        private bool IsNear(in FloatingPart a, in FloatingPart b)
        {
            float turn = FloatingPose.Turn(Quaternion.Inverse(a.Rotation) * b.Rotation).magnitude;
            return (a.Position - b.Position).magnitude + turn * Mathf.Max(1f, a.Position.magnitude) < tolerance;
        }

        private void Forget()
        {
            var gone = new List<BodyMotion>();
            foreach (BodyMotion motion in rests.Keys)
                if (!attached.Contains(motion)) gone.Add(motion);
            foreach (BodyMotion motion in gone) rests.Remove(motion);
        }

        private void Upload()
        {
            GpuBuffers.Reserve(ref inputBuffer, "Floating Inputs", slots.Count, FloatingInput.Stride);
            GpuBuffers.Reserve(ref partBuffer, "Floating Parts", attached.Count, FloatingPart.Stride);
            inputBuffer.SetData(inputs, 0, 0, slots.Count);
            partBuffer.SetData(parts, 0, 0, attached.Count);
            RequireStates();
        }

        private void RequireStates()
        {
            if (stateBuffer != null) return;
            stateBuffer = GpuBuffers.Create("Floating States", Most, FloatingState.Stride);
            sumBuffer = GpuBuffers.Create("Impulse Sums", Most * Words, sizeof(uint));
            sumBuffer.SetData(new uint[Most * Words]);
        }

        // The next one at or above a number: 0.3 gives 0.5.
        private static float PowerOfTwo(double value) => (float)Math.Pow(2.0, Math.Ceiling(Math.Log(value, 2.0)));
    }
}
