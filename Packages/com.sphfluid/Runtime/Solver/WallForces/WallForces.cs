using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The force of a liquid on rectangles of its walls, from <see cref="FluidSolver.WallForces"/>. Summed on the GPU in every step in
    /// whole units, so that equal runs read the same; read back with the steps, without waiting. This is the force with which the wall
    /// holds the liquid: what a pressure gauge in the wall would feel. A mean of the particles' own pressure is not, least of all in a hit.
    /// </summary>
    /// <example>
    /// <code>
    /// WallPatch floor = solver.WallForces.Add(new Vector3(0f, -0.5f, 0f), Quaternion.LookRotation(Vector3.up, Vector3.forward), new
    /// Vector2(0.2f, 0.2f)); // record and execute steps, for some frames double pressure = floor.MeanPressure(0.1); // Pa, over the last
    /// 0.1 s that have been read back
    /// </code>
    /// </example>
    public sealed class WallForces
    {
        /// <summary>Most rectangles of a liquid.</summary>
        public const int Most = 64;

        /// <summary>Most parts that a batch of steps is sampled in; one of more steps has several steps a part.</summary>
        public const int MostParts = 64;

        private static readonly int PatchesId = Shader.PropertyToID("_WallPatches");
        private static readonly int SumsId = Shader.PropertyToID("_WallSums");
        private static readonly int UnitsId = Shader.PropertyToID("_PatchUnits");
        private static readonly int ReachId = Shader.PropertyToID("_PatchReach");

        // Spacings about a foot: less and the first rows in an edge differ, the first layer being denser; more and they see too far.
        private const float SpreadReach = 0.94f;

        private readonly FluidShaderSet shaders;
        private readonly List<WallPatch> patches = new List<WallPatch>();
        private readonly AskedPatch[] asked = new AskedPatch[Most];
        private readonly WallReadback readback;
        private PlaceWallPatchesPass pass;
        private GraphicsBuffer askedBuffer, placedBuffer, sumBuffer;
        private WallReadback.Batch batch; // of the steps that are recorded; null: nothing is summed
        private bool isCarried;

        internal WallForces(FluidShaderSet shaders)
        {
            this.shaders = shaders;
            readback = new WallReadback(() => Received?.Invoke(this));
        }

        /// <summary>Raised on the main thread when the sums of some steps have arrived, after every patch has taken its own.</summary>
        public event Action<WallForces> Received;

        /// <summary>The rectangles.</summary>
        public IReadOnlyList<WallPatch> Patches => patches;

        /// <summary>GPU memory [bytes].</summary>
        public long GpuBytes => GpuBuffers.Size(askedBuffer, placedBuffer, sumBuffer);

        /// <summary>Whether the steps that are recorded are summed.</summary>
        internal bool IsOn => batch != null;

        /// <summary>None so far, on a device that can sum them.</summary>
        /// <exception cref="FluidDeviceException">The device cannot.</exception>
        internal static WallForces Start(FluidShaderSet shaders)
        {
            if (Shortfall() is string shortfall) throw new FluidDeviceException(shortfall);
            return new WallForces(shaders);
        }

        /// <summary>Why the device cannot sum them; null where it can.</summary>
        internal static string Shortfall()
        {
            foreach (string shortfall in ShaderGroup.WallForces.Shortfalls(DeviceCapabilities.Query())) return shortfall;
            return null;
        }

        /// <summary>Adds a rectangle; the next steps that are recorded are summed.</summary>
        /// <param name="centre">Its centre, on a wall [m, simulation space].</param>
        /// <param name="rotation">x and y axes along its edges, z out of the wall towards the liquid.</param>
        /// <param name="size">Edge lengths along its x and y axes [m].</param>
        /// <param name="depth">How far before and behind it a wall belongs to it [m]; 0: one particle spacing.</param>
        /// <returns>What holds its sums.</returns>
        /// <exception cref="ArgumentException">A number is not finite, an edge is not positive, or the depth is negative.</exception>
        /// <exception cref="InvalidOperationException">There are <see cref="Most"/> already.</exception>
        public WallPatch Add(Vector3 centre, Quaternion rotation, Vector2 size, float depth = 0f)
        {
            Check(centre, rotation, size);
            Require.NotNegative(depth, nameof(depth));
            if (patches.Count == Most)
            {
                throw new InvalidOperationException($"A liquid has at most {Most} wall patches. Remove one, or read a larger one.");
            }
            var patch = new WallPatch { Centre = centre, Rotation = rotation.normalized, Size = size, Depth = depth };
            patches.Add(patch);
            return patch;
        }

        /// <summary>Puts a rectangle elsewhere; its sums go on.</summary>
        /// <param name="patch">The rectangle.</param>
        /// <param name="centre">Its centre, on a wall [m, simulation space].</param>
        /// <param name="rotation">x and y axes along its edges, z out of the wall towards the liquid.</param>
        /// <param name="size">Edge lengths along its x and y axes [m].</param>
        /// <exception cref="ArgumentException">As of <see cref="Add"/>, or it is none of these.</exception>
        public void Move(WallPatch patch, Vector3 centre, Quaternion rotation, Vector2 size)
        {
            Check(centre, rotation, size);
            if (!patches.Contains(patch))
            {
                throw new ArgumentException("The wall patch was removed, or is one of another liquid.", nameof(patch));
            }
            (patch.Centre, patch.Rotation, patch.Size) = (centre, rotation.normalized, size);
        }

        /// <summary>Ends a rectangle; what it has read stays. One that is none of these is left as it is.</summary>
        /// <param name="patch">The rectangle.</param>
        public void Remove(WallPatch patch) => patches.Remove(patch);

        /// <summary>Waits for the sums that are under way; for tools and tests.</summary>
        public void Complete() => readback.Wait();

        /// <summary>Where the rectangles were in the last step; null before the first.</summary>
        internal GraphicsBuffer Placed => placedBuffer;

        /// <summary>Begins a batch of steps.</summary>
        /// <param name="state">The liquid.</param>
        /// <param name="steps">Number of steps, 1 or more.</param>
        /// <param name="solids">What the liquid collides with.</param>
        internal void Begin(FluidState state, int steps, IReadOnlyList<FluidObstacle> solids)
        {
            readback.TakeReady();
            batch = null;
            if (patches.Count == 0) return;
            pass ??= new PlaceWallPatchesPass(shaders);
            askedBuffer ??= GpuBuffers.Create("Asked Wall Patches", Most, AskedPatch.Stride);
            placedBuffer ??= GpuBuffers.Create("Wall Patches", Most, PlacedStride);
            sumBuffer ??= GpuBuffers.Create("Wall Sums", 2L * Most * MostParts, sizeof(uint));
            FluidSolverSettings settings = state.Settings;
            isCarried = false;
            for (int i = 0; i < patches.Count; i++) asked[i] = Asked(patches[i], state, solids);
            askedBuffer.SetData(asked, 0, 0, patches.Count);
            batch = readback.Begin(patches, steps, UnitOf(settings));
        }

        /// <summary>Records where the rectangles are in a step, before its motion.</summary>
        internal void RecordStep(CommandBuffer cmd, FluidState state, in FluidStep step, double endTime)
        {
            if (batch == null) return;
            bool begins = batch.AddStep(endTime, step.IsFirst ? 0.5f * step.Length : step.Kick);
            pass.Record(cmd, state, this, patches.Count, batch.FirstWord, begins, isCarried);
        }

        /// <summary>Records the read-back behind the last step of a batch.</summary>
        internal void End(CommandBuffer cmd)
        {
            if (batch != null) readback.RecordRequest(cmd, sumBuffer, batch);
            batch = null;
        }

        /// <summary>
        /// Records the keyword and the globals of Shaders/Solver/WallForces/WallPatches.hlsl for a kernel that changes velocities at walls.
        /// </summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">Kernel with the keyword.</param>
        /// <param name="state">The liquid.</param>
        internal static void Set(CommandBuffer cmd, ComputeKernel kernel, FluidState state)
        {
            WallForces forces = state.WallForces;
            bool on = forces != null && forces.IsOn;
            kernel.SetKeyword(cmd, ShaderGroup.WallForces.Keyword, on);
            if (!on) return;
            kernel.SetBuffer(cmd, PatchesId, forces.placedBuffer);
            kernel.SetBuffer(cmd, SumsId, forces.sumBuffer);
            kernel.SetFloat(cmd, UnitsId, (float)(state.Settings.ParticleMass / forces.batch.Unit));
            kernel.SetFloat(cmd, ReachId, SpreadReach * state.Settings.Spacing);
        }

        internal void Bind(CommandBuffer cmd, ComputeKernel kernel, int askedId, int placedId)
        {
            kernel.SetBuffer(cmd, askedId, askedBuffer);
            kernel.SetBuffer(cmd, placedId, placedBuffer);
            kernel.SetBuffer(cmd, SumsId, sumBuffer);
        }

        internal void Dispose()
        {
            readback.Dispose();
            GpuBuffers.Dispose(ref askedBuffer);
            GpuBuffers.Dispose(ref placedBuffer);
            GpuBuffers.Dispose(ref sumBuffer);
        }

        private AskedPatch Asked(WallPatch patch, FluidState state, IReadOnlyList<FluidObstacle> solids)
        {
            var words = new AskedPatch
            {
                Centre = patch.Centre,
                Rotation = patch.Rotation,
                HalfSize = new Vector2(HalfEdge(patch.Rotation * Vector3.right, patch.Size.x, state.Settings),
                    HalfEdge(patch.Rotation * Vector3.up, patch.Size.y, state.Settings)),
                Depth = patch.Depth > 0f ? patch.Depth : state.Settings.Spacing,
            };
            BodyMotion motion = patch.Carrier != null ? state.Bodies?.MotionOf(patch.Carrier) : null;
            if (motion != null)
            {
                Quaternion toBody = Quaternion.Inverse(motion.Rotation1);
                words.Centre = toBody * (patch.Centre - motion.Position1);
                words.Rotation = (toBody * patch.Rotation).normalized;
                words.Body = (uint)(state.Bodies.PlaceOf(motion) + 1);
                isCarried |= words.Body != 0u;
            }
            patch.FindCover((words.Centre, words.Rotation, patch.Size, patch.Carrier, solids.Count), words.Depth, state.Settings, solids);
            words.Ends = patch.Cover.Value.Ends;
            return words;
        }

        // A rectangle that goes round a periodic domain has no edge there: particles beside the seam count whole.
        private static float HalfEdge(Vector3 direction, float length, in FluidSolverSettings settings)
        {
            Vector3 periods = settings.PeriodLength;
            for (int axis = 0; axis < 3; axis++)
            {
                bool goesRound = periods[axis] > 0f && Mathf.Abs(direction[axis]) > 0.9999f &&
                    length > periods[axis] - 1e-3f * settings.Spacing;
                if (goesRound) return 0.5f * Mathf.Max(length, periods[axis]) + settings.Spacing;
            }

            return 0.5f * length;
        }

        private static void Check(Vector3 centre, Quaternion rotation, Vector2 size)
        {
            Require.Place(centre, rotation);
            Require.Area(size, nameof(size));
        }

        // N s, a power of two: 2^26 of it are a particle at the speed of sound.
        private static double UnitOf(in FluidSolverSettings settings) =>
            Math.Pow(2.0,
                Math.Ceiling(Math.Log(settings.ParticleMass * (double)Math.Max(settings.SoundSpeed, settings.MaxSpeed), 2.0)) - 26.0);

        private const int PlacedStride = 80;

        [StructLayout(LayoutKind.Sequential)]
        private struct AskedPatch
        {
            public const int Stride = 64;

            public Vector3 Centre;
            public uint Body;
            public Quaternion Rotation;
            public Vector2 HalfSize;
            public float Depth;
            public uint Unused;
            public Vector4 Ends;
        }
    }
}
