using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>A running liquid to bytes and back.</summary>
    public sealed class SavingTests
    {
        private const float Spacing = 0.05f;
        private const float Frame = 1f / 64f; // sums of it are exact: the times of a later run differ by whole frames

        private readonly float fixedDelta = Time.fixedDeltaTime;
        private SimulationRig rig;
        private FluidSimulation simulation;
        private Transform paddle;
        private Mesh waving;
        private int frame;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(Frame);
            Time.fixedDeltaTime = Frame;
            simulation = rig.Create(liquid: false);
            simulation.DomainSize = new Vector3(0.6f, 0.6f, 0.4f);
            simulation.Spacing = Spacing;
            FluidVolume water = rig.AddVolume(simulation);
            water.Size = new Vector3(0.6f, 0.3f, 0.4f);
            water.transform.localPosition = new Vector3(0f, -0.15f, 0f);
            paddle = null;
            waving = null;
            frame = 0;
        }

        [TearDown]
        public void TearDown()
        {
            Time.fixedDeltaTime = fixedDelta;
            if (waving != null) Object.DestroyImmediate(waving);
            rig.Dispose();
        }

        private Transform AddPaddle()
        {
            GameObject holder = rig.NewObject("Paddle");
            holder.AddComponent<BoxCollider>().size = new Vector3(0.05f, 0.4f, 0.25f);
            paddle = holder.transform;
            Swing();
            return paddle;
        }

        // A cube whose top goes to and fro; it moves as well.
        private void AddWavingMesh()
        {
            waving = TestMeshes.Cube();
            AddPaddle();
            Object.DestroyImmediate(paddle.GetComponent<BoxCollider>());
            paddle.gameObject.AddComponent<MeshCollider>().sharedMesh = waving;
            Swing();
        }

        private void Wave()
        {
            Vector3[] corners = waving.vertices;
            for (int i = 0; i < corners.Length; i++)
                if (corners[i].y > 0f)
                {
                    corners[i] = new Vector3(Mathf.Sign(corners[i].x) * 0.5f, 0.5f + 0.2f * Mathf.Sin(0.2f * frame), corners[i].z);
                }
            waving.vertices = corners;
            waving.RecalculateBounds();
        }

        // To and fro, turning and growing.
        private void Swing()
        {
            if (waving != null) Wave();
            if (paddle == null) return;
            float phase = 0.1f * frame;
            paddle.SetPositionAndRotation(new Vector3(-0.2f + 0.05f * Mathf.Sin(phase), -0.1f, 0f),
                Quaternion.Euler(0f, 0f, 10f * Mathf.Sin(0.7f * phase)));
            paddle.localScale = (waving != null ? 0.3f : 1f) * (1f + 0.1f * Mathf.Sin(0.5f * phase)) * Vector3.one;
        }

        private Rigidbody AddCrate()
        {
            GameObject crate = rig.NewObject("Crate");
            crate.transform.SetPositionAndRotation(new Vector3(0.1f, 0.05f, 0f), Quaternion.Euler(8f, 0f, 3f));
            crate.AddComponent<BoxCollider>().size = new Vector3(0.25f, 0.15f, 0.25f);
            Rigidbody body = crate.AddComponent<Rigidbody>();
            body.mass = 4f;
            return body;
        }

        private FluidEmitter AddNozzle()
        {
            GameObject holder = rig.NewObject("Nozzle");
            holder.transform.SetParent(simulation.transform, false);
            holder.transform.SetPositionAndRotation(new Vector3(0.2f, 0.2f, 0.1f), Quaternion.LookRotation(Vector3.down, Vector3.right));
            FluidEmitter emitter = holder.AddComponent<FluidEmitter>();
            emitter.Size = new Vector2(0.12f, 0.12f);
            emitter.Speed = 1.1f;
            emitter.Lifetime = 0.2f;
            return emitter;
        }

        private FluidDrain AddDrain()
        {
            GameObject holder = rig.NewObject("Drain");
            holder.transform.SetParent(simulation.transform, false);
            holder.transform.localPosition = new Vector3(-0.2f, -0.25f, 0.1f);
            FluidDrain drain = holder.AddComponent<FluidDrain>();
            drain.Size = new Vector3(0.15f, 0.1f, 0.15f);
            return drain;
        }

        private IEnumerator Play(int frames, List<ulong> hashes = null)
        {
            while (!simulation.IsRunning) yield return null;
            for (int i = 0; i < frames; i++)
            {
                frame++;
                Swing();
                yield return null;
                hashes?.Add(simulation.ComputeStateHash());
            }
        }

        private byte[] Save()
        {
            var stream = new MemoryStream();
            simulation.Save(stream);
            return stream.ToArray();
        }

        private IEnumerator CheckContinuation(Rigidbody crate, int before = 8, int after = 5)
        {
            yield return Play(before);
            byte[] save = Save();
            ulong saved = simulation.ComputeStateHash();
            (double time, long steps, int savedFrame) = (simulation.SimulatedTime, simulation.StepCount, frame);
            float[] place = PlaceOf(crate);
            var first = new List<ulong>();
            yield return Play(after, first);
            Assert.That(first.Distinct().Count(), Is.EqualTo(after), "the liquid moves");

            frame = savedFrame;
            Swing();
            Bring(crate, place);
            FluidSolver old = simulation.Solver;
            Assert.That(simulation.Restore(new MemoryStream(save)), simulation.StatusMessage);
            Assert.That(simulation.Solver, Is.Not.SameAs(old));
            Assert.That(simulation.ComputeStateHash(), Is.EqualTo(saved));
            Assert.That((simulation.SimulatedTime, simulation.StepCount), Is.EqualTo((time, steps)));
            var second = new List<ulong>();
            yield return Play(after, second);
            Assert.That(second, Is.EqualTo(first));
            Assert.That(simulation.Messages.Where(m => m.Issue == FluidIssue.SaveDiffers || m.Issue == FluidIssue.SaveInvalid), Is.Empty);
        }

        // What a game saves of a Rigidbody.
        private static float[] PlaceOf(Rigidbody body)
        {
            if (body == null) return new float[0];
#pragma warning disable 618 // linearVelocity in Unity 6
            (Vector3 p, Quaternion q, Vector3 v, Vector3 w) = (body.position, body.rotation, body.velocity, body.angularVelocity);
            return new[] { p.x, p.y, p.z, q.x, q.y, q.z, q.w, v.x, v.y, v.z, w.x, w.y, w.z };
        }

        private static void Bring(Rigidbody body, float[] n)
        {
            if (body == null) return;
            var position = new Vector3(n[0], n[1], n[2]);
            var rotation = new Quaternion(n[3], n[4], n[5], n[6]);
            body.transform.SetPositionAndRotation(position, rotation);
            (body.position, body.rotation) = (position, rotation);
            body.velocity = new Vector3(n[7], n[8], n[9]);
            body.angularVelocity = new Vector3(n[10], n[11], n[12]);
#pragma warning restore 618
        }

        [UnityTest]
        public IEnumerator ARestoredLiquidGoesOnToTheBit([Values] FluidTimeStepMode mode, [Values] bool follows)
        {
            simulation.TimeStepMode = mode;
            simulation.FixedTimeStep = 0.002f;
            rig.Profile.SoundSpeedMode = follows ? FluidSoundSpeedMode.FollowsLiquid : FluidSoundSpeedMode.FixedByRule;
            yield return CheckContinuation(null);
        }

        [UnityTest]
        public IEnumerator WithAColliderThatMoves() { AddPaddle(); return CheckContinuation(null); }

        [UnityTest]
        public IEnumerator WithAMeshThatDeforms() { AddWavingMesh(); return CheckContinuation(null); }

        [UnityTest]
        public IEnumerator WithEmittersAndDrains()
        {
            AddPaddle();
            FluidEmitter emitter = AddNozzle();
            FluidDrain drain = AddDrain();
            yield return CheckContinuation(null, 16); // the first that was poured has gone
            Assert.That(emitter.EmittedVolume, Is.Positive);
            Assert.That(drain.DrainedVolume, Is.Positive);
        }

        [UnityTest]
        public IEnumerator WithAPumpThatMoves()
        {
            FluidEmitter pump = AddNozzle();
            pump.UnderWater = true;
            paddle = pump.transform; // Swing() moves it
            Swing();
            yield return CheckContinuation(null);
            Assert.That(pump.EmittedVolume, Is.Positive);
        }

        [UnityTest]
        public IEnumerator WithABodyThatFloats()
        {
            AddPaddle();
            yield return CheckContinuation(AddCrate());
        }

        [UnityTest]
        public IEnumerator WithTheGradientCorrection()
        {
            rig.Profile.GradientCorrection = true;
            AddPaddle();
            AddNozzle();
            AddDrain();
            yield return CheckContinuation(AddCrate(), 16);
            Assert.That(SimulationRig.Read(simulation).Count(p => p.DensityOffset != 0f), Is.GreaterThan(100));
            byte[] save = Save();
            rig.Profile.GradientCorrection = false;
            Assert.That(simulation.Restore(new MemoryStream(save)), simulation.StatusMessage);
            yield return Play(2);
            Assert.That(SimulationRig.Read(simulation).Count(p => p.DensityOffset != 0f), Is.Zero);
        }

        [UnityTest]
        public IEnumerator InTheFrameInWhichABodyGoes()
        {
            Rigidbody crate = AddCrate();
            yield return Play(5);
            Object.DestroyImmediate(crate.gameObject);
            Assert.That(Save(), Is.Not.Empty);
            yield return Play(3);
            Assert.That(simulation.IsRunning, simulation.StatusMessage);
        }

        [UnityTest]
        public IEnumerator ByTheThesisMethod()
        {
            simulation.Method = FluidMethodKind.Thesis;
            yield return CheckContinuation(null, 5, 5);
        }

        /// <summary>
        /// With a folder in SPHFLUID_SAVE_FOLDER, a first process saves there and goes on, and a second one, of the same command, restores
        /// and compares; SPHFLUID_SAVE_FRAMES frames after the save. Without, one process does both, in scenes of their own.
        /// </summary>
        [UnityTest]
        public IEnumerator InAnotherProcess()
        {
            string given = Environment.GetEnvironmentVariable("SPHFLUID_SAVE_FOLDER");
            int frames = int.Parse(Environment.GetEnvironmentVariable("SPHFLUID_SAVE_FRAMES") ?? "5", CultureInfo.InvariantCulture);
            string folder = given ?? TestFolder.Fresh();
            Directory.CreateDirectory(folder);
            if (!File.Exists(Path.Combine(folder, "hashes.txt"))) yield return SaveAndGoOn(folder, frames);
            else yield return RestoreAndCompare(folder, frames);
            if (given != null) yield break;
            TearDown();
            SetUp();
            yield return RestoreAndCompare(folder, frames);
            TestFolder.Delete(folder);
        }

        private IEnumerator SaveAndGoOn(string folder, int frames)
        {
            AddPaddle();
            AddNozzle();
            Rigidbody crate = AddCrate();
            yield return Play(12);
            File.WriteAllBytes(Path.Combine(folder, "liquid.save"), Save());
            var place = new byte[13 * sizeof(float)];
            Buffer.BlockCopy(PlaceOf(crate), 0, place, 0, place.Length);
            File.WriteAllBytes(Path.Combine(folder, "crate.bytes"), place);
            var hashes = new List<ulong>();
            yield return Play(frames, hashes);
            File.WriteAllLines(Path.Combine(folder, "hashes.txt"),
                hashes.Select(h => h.ToString("X16", CultureInfo.InvariantCulture)).Append($"{simulation.StepCount} steps"));
        }

        private IEnumerator RestoreAndCompare(string folder, int frames)
        {
            yield return Play(2); // the first frame has a time of its own
            frame = 12;
            AddPaddle();
            AddNozzle();
            Rigidbody crate = AddCrate();
            var place = new float[13];
            byte[] bytes = File.ReadAllBytes(Path.Combine(folder, "crate.bytes"));
            Buffer.BlockCopy(bytes, 0, place, 0, bytes.Length);
            Bring(crate, place);
            using (FileStream stream =
                File.OpenRead(Path.Combine(folder, "liquid.save"))) Assert.That(simulation.Restore(stream), simulation.StatusMessage);
            var hashes = new List<ulong>();
            yield return Play(frames, hashes);
            string[] first = File.ReadAllLines(Path.Combine(folder, "hashes.txt"));
            Assert.That(hashes.Select(h => h.ToString("X16", CultureInfo.InvariantCulture)).Append($"{simulation.StepCount} steps"),
                Is.EqualTo(first));
            Assert.That(hashes.Distinct().Count(), Is.EqualTo(frames));
        }
    }
}
