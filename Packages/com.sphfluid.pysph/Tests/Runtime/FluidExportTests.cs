using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Liquids of a scene as cases of PySPH: what is in them, and that nothing is left out in silence.</summary>
    public sealed class FluidExportTests
    {
        private SimulationRig rig;
        private FluidSimulation simulation;
        private string folder;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(1f / 64f);
            simulation = rig.Create("Tank");
            simulation.Boundaries = new FluidBoundaries { Friction = 1f };
            simulation.StopSimulation();
            folder = TestFolder.Fresh();
        }

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            TestFolder.Delete(folder);
        }

        private static FluidExportOptions Options(double seconds = 0.125) => new FluidExportOptions { Seconds = seconds, FrameRate = 64.0 };

        private T Add<T>(string name, Vector3 place = default) where T : Component
        {
            GameObject holder = rig.NewObject(name);
            holder.transform.position = place;
            return holder.AddComponent<T>();
        }

        private BoxCollider AddBox(string name, Vector3 place = default)
        {
            BoxCollider box = Add<BoxCollider>(name, place);
            box.size = new Vector3(0.05f, 0.2f, 0.2f);
            return box;
        }

        private ExportManifest Manifest() => JsonUtility.FromJson<ExportManifest>(File.ReadAllText(Path.Combine(folder, "manifest.json")));

        // Rows of a table of numbers, each as its bytes.
        private byte[][] Rows(string name, int size)
        {
            byte[] file = File.ReadAllBytes(Path.Combine(folder, name));
            int first = 10 + file[8] + 256 * file[9];
            return Enumerable.Range(0, (file.Length - first) / size)
                .Select(i => file.Skip(first + i * size).Take(size).ToArray()).ToArray();
        }

        private static Vector3 Vector(byte[] row, int at) =>
            new Vector3(BitConverter.ToSingle(row, at), BitConverter.ToSingle(row, at + 4), BitConverter.ToSingle(row, at + 8));

        private IEnumerable<FluidMessage> LeftOut()
        {
            using (FluidExport export =
                FluidExport.Begin(simulation, Options())) return export.Messages.Where(m => m.Issue == FluidIssue.NotExported).ToArray();
        }

        [Test]
        public void ALiquidIsExportedAsItIsFilled()
        {
            using (FluidExport export = FluidExport.Begin(simulation, Options()))
            {
                Assert.That(export.HasLiquid, Is.True);
                Assert.That(export.LeavesOut, Is.False, string.Join("\n", export.Messages));
                export.Write(folder);
            }

            byte[][] rows = Rows("liquid.npy", 28);
            Assert.That(rows.Length, Is.EqualTo(64).And.EqualTo(Manifest().liquidParticles));
            Assert.That(rows.Select(r => BitConverter.ToUInt32(r, 24)), Is.EqualTo(Enumerable.Range(0, 64).Select(i => (uint)i)));
            Assert.That(rows.All(r => Mathf.Abs(Vector(r, 0).x) < 0.1f), Is.True);
            Assert.That(simulation.IsRunning, Is.False, "an export starts nothing");
        }

        [UnityTest]
        public IEnumerator ARunningLiquidIsExportedAsItIs()
        {
            simulation.StartSimulation();
            for (int i = 0; i < 5; i++) yield return null;
            using (FluidExport export = FluidExport.Begin(simulation, Options())) export.Write(folder);

            FluidParticle[] particles = SimulationRig.Read(simulation);
            Assert.That(particles.Max(p => p.VelT0.magnitude), Is.Positive, "it falls");
            Assert.That(Rows("liquid.npy", 28).Select(r => (Vector(r, 0), Vector(r, 12), BitConverter.ToUInt32(r, 24))),
                Is.EqualTo(particles.Select(p => (p.Position, p.VelT0, p.Id))));
        }

        [Test]
        public void AnotherMachineHoldsMoreThanTheProfileAllows()
        {
            rig.Profile.MaxParticles = 63;
            Assert.That(simulation.Validate().Any(m => m.Issue == FluidIssue.TooManyParticles), Is.True);

            using (FluidExport export = FluidExport.Begin(simulation, Options())) Assert.That(export.ParticleCount, Is.EqualTo(64));
        }

        [TestCase(FluidStartRelaxation.None, false)]
        [TestCase(FluidStartRelaxation.Packed, true)]
        public void AnotherMachineHoldsADomainOfMoreCells(FluidStartRelaxation relaxation, bool isToldOf)
        {
            simulation.DomainSize = 400f * Vector3.one;
            simulation.StartRelaxation = relaxation;
            Assert.That(simulation.Validate().Any(m => m.Issue == FluidIssue.TooManyCells), Is.True);

            using (FluidExport export = FluidExport.Begin(simulation, Options()))
            {
                Assert.That((export.HasLiquid, export.ParticleCount), Is.EqualTo((true, 64)));
                Assert.That(export.Messages.Any(m => m.Issue == FluidIssue.StartRelaxation && m.Text.Contains("exported as filled")),
                    Is.EqualTo(isToldOf));
                Assert.That(export.Messages.Where(m => m.Severity == FluidSeverity.Error), Is.Empty);
            }
        }

        [Test]
        public void WithoutLiquidThereIsNothingToWrite()
        {
            foreach (FluidVolume volume in simulation.GetComponentsInChildren<FluidVolume>()) volume.enabled = false;
            using (FluidExport export = FluidExport.Begin(simulation, Options()))
            {
                Assert.That(export.HasLiquid, Is.False);
                Assert.That(export.Messages.Any(m => m.Issue == FluidIssue.NoLiquid && m.Severity == FluidSeverity.Error), Is.True);
                Assert.That(() => export.Write(folder), Throws.InvalidOperationException.With.Message.Contains("'Tank'"));
            }
        }

        [TestCase(0.0, 30.0, 2)]
        [TestCase(double.NaN, 30.0, 2)]
        [TestCase(1.0, -1.0, 2)]
        [TestCase(1e6, 1e6, 2)]
        [TestCase(1.0, 30.0, 0)]
        public void OptionsOutOfRangeAreRefused(double seconds, double frameRate, int ranks) =>
            Assert.That(() =>
                FluidExport.Begin(simulation, new FluidExportOptions { Seconds = seconds, FrameRate = frameRate, Ranks = ranks }),
                Throws.ArgumentException);

        private static readonly (string name, Action<FluidExportTests> add, string words)[] Unsupported =
        {
            ("Nozzle", t => t.Add<FluidEmitter>("Nozzle"), "The emitter is not exported"),
            ("Hole", t => t.Add<FluidDrain>("Hole"), "The drain is not exported"),
            ("Wind", t => t.Add<FluidForceZone>("Wind"), "The force zone is not exported"),
            ("Flow Meter", t => t.Add<FluidFlux>("Flow Meter"), "The instrument is not exported"),
            ("Switch", t => t.Add<FluidSensor>("Switch"), "The sensor is not exported"),
            ("Tank", t => t.simulation.BodyForce = new FluidBodyForce { RateSquared = Vector3.one }, "The body force is not exported"),
            ("Tank", t => t.simulation.Boundaries = new FluidBoundaries { Friction = 1f, Open = FluidFaces.HighX },
                "Open faces (HighX) remove nothing"),
            ("Tank", t => t.simulation.Boundaries = new FluidBoundaries { Friction = 1f, Periodic = FluidAxes.Z }, "The periodic axes (Z)"),
            ("Crate", t => t.AddBox("Crate", new Vector3(0.15f, 0f, 0f)).gameObject.AddComponent<Rigidbody>(), "is moved by the liquid"),
            ("Test Water", t => (t.rig.Profile.SurfaceTension, t.rig.Profile.TensionAtAnySpacing) = (0.07f, true),
                "Surface tension is not exported"),
            ("Test Water", t => t.rig.Profile.KinematicViscosity = 1f, "Implicit viscosity is not exported"),
        };

        private static IEnumerable<TestCaseData> UnsupportedParts() =>
            Unsupported.Select((part, i) => new TestCaseData(i).SetName($"{{m}}({part.name}: {part.words})"));

        [TestCaseSource(nameof(UnsupportedParts))]
        public void WhatPysphCannotExpressIsNamedOnce(int index)
        {
            (string name, Action<FluidExportTests> add, string words) = Unsupported[index];
            add(this);

            FluidMessage message = LeftOut().Single(m => m.Text.Contains(words));
            Assert.That(message.Source, Is.EqualTo(name));
            Assert.That(message.Severity, Is.EqualTo(FluidSeverity.Warning));
        }

        [Test]
        public void PartialFrictionAndMissingProofsAreWorthKnowing()
        {
            simulation.Boundaries = new FluidBoundaries { Friction = 0.25f };
            FluidMessage[] messages = LeftOut().ToArray();

            Assert.That(messages.All(m => m.Severity == FluidSeverity.Info), Is.True);
            Assert.That(messages.Any(m => m.Text.StartsWith("Friction of 0.25 is not exported")), Is.True);
            Assert.That(messages.Any(m => m.Text.StartsWith("Contact is not proved in PySPH")), Is.True);
        }

        [Test]
        public void AnOpenMeshIsSaidToBeASheet()
        {
            MeshCollider sheet = Add<MeshCollider>("Sheet");
            var mesh = new Mesh { vertices = TestMeshes.Sheet().Vertices, triangles = TestMeshes.Sheet().Indices };
            try
            {
                sheet.sharedMesh = mesh;
                Assert.That(LeftOut().Single(m => m.Source == "Sheet").Text, Does.Contain("is an open mesh"));
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(mesh);
            }
        }

        [UnityTest]
        public IEnumerator AColliderThatMovesIsABodyWithItsPath()
        {
            Transform paddle = AddBox("Paddle", new Vector3(-0.15f, 0f, 0f)).transform;
            AddBox("Post", new Vector3(0.15f, 0f, 0f));
            using (FluidExport export = FluidExport.Begin(simulation, Options()))
            {
                for (int i = 1; i <= 8; i++)
                {
                    yield return null;
                    paddle.position = new Vector3(-0.15f + 0.01f * i, 0f, 0f);
                    paddle.rotation = Quaternion.Euler(0f, 0f, 10f * i);
                    export.Note(i / 64.0);
                }
                Assert.That(export.IsComplete, Is.True);
                Assert.That(export.Progress, Is.EqualTo(1f));
                export.Write(folder);
            }

            ExportManifest.Body body = Manifest().bodies.Single();
            Assert.That((body.name, body.poses), Is.EqualTo(("Paddle", 9)));
            byte[][] rows = Rows("body-000-path.npy", 36);
            Assert.That(BitConverter.ToDouble(rows[8], 0), Is.EqualTo(0.125));
            Assert.That((Vector(rows[8], 8) - new Vector3(-0.07f, 0f, 0f)).magnitude, Is.LessThan(1e-6f));
            Assert.That(BitConverter.ToSingle(rows[8], 28), Is.EqualTo(Mathf.Sin(40f * Mathf.Deg2Rad)).Within(1e-4f), "qz of 80 degrees");
            Vector3[] particles = Rows("body-000.npy", 24).Select(r => Vector(r, 0)).ToArray();
            Assert.That(particles.Length, Is.EqualTo(body.particles).And.Positive);
            Assert.That(particles.All(p => Mathf.Abs(p.x) <= 0.0251f && Mathf.Abs(p.y) <= 0.1001f && Mathf.Abs(p.z) <= 0.1001f), Is.True,
                "from the pivot, at the start's turn");
            Vector3[] walls = Rows("walls.npy", 24).Select(r => Vector(r, 0)).ToArray();
            Assert.That(walls.Any(p => Mathf.Abs(p.x - 0.15f) <= 0.0251f && Mathf.Abs(p.y) < 0.1f && Mathf.Abs(p.z) < 0.1f), Is.True,
                "the post is a wall");
            Assert.That(walls.Any(p => Mathf.Abs(p.x + 0.15f) <= 0.0251f && Mathf.Abs(p.y) < 0.1f && Mathf.Abs(p.z) < 0.1f), Is.False,
                "the paddle is none");
        }

        [UnityTest]
        public IEnumerator WhatPysphCannotFollowIsNamedOnceWhileItHappens()
        {
            Transform growing = AddBox("Growing", new Vector3(-0.15f, 0f, 0f)).transform,
                leaving = AddBox("Leaving", new Vector3(0.15f, 0f, 0f)).transform;
            BoxCollider late = null;
            using (FluidExport export = FluidExport.Begin(simulation, Options()))
            {
                for (int i = 1; i <= 4; i++)
                {
                    yield return null;
                    growing.localScale = (1f + 0.1f * i) * Vector3.one;
                    leaving.position = new Vector3(0.15f + 0.5f * i, 0f, 0f);
                    if (late == null) late = AddBox("Late");
                    simulation.transform.position = new Vector3(0f, 0.01f * i, 0f);
                    export.Note(i / 64.0);
                }
                foreach ((string name, string words) in new[]
                {
                    ("Growing", "changes its size or shape"), ("Leaving", "leaves the domain or is switched off"),
                    ("Late", "comes into the domain after"), ("Tank", "The domain itself moves"),
                })
                {
                    Assert.That(export.Messages.Count(m => m.Source == name && m.Text.Contains(words)), Is.EqualTo(1), name);
                }
                Assert.That(export.LeavesOut, Is.True);
                export.Write(folder);
            }
            Assert.That(Manifest().notExported.Select(n => n.name), Is.SupersetOf(new[] { "Growing", "Leaving", "Late", "Tank" }));
        }

        [Test]
        public void ProbesAndGaugesAreReadOfWhatPysphComputes()
        {
            FluidProbe probe = Add<FluidProbe>("Wall Probe", new Vector3(0.1f, 0f, 0f));
            Add<FluidProbe>("Pitot", Vector3.zero).Kind = FluidProbeKind.Velocity;
            Add<FluidGauge>("Gauge", new Vector3(0f, -0.2f, 0f)).Length = 0.4f;
            using (FluidExport export = FluidExport.Begin(simulation, Options()))
            {
                Assert.That(export.LeavesOut, Is.False, string.Join("\n", export.Messages));
                export.Write(folder);
            }

            ExportManifest.Reading[] readings = Manifest().readings.ToArray();
            Assert.That(readings.Select(r => (r.name, r.property)), Is.EqualTo(new[]
            {
                ("Wall Probe", "p"), ("Pitot", "u"), ("Pitot", "v"), ("Pitot", "w"), ("Gauge", "height"),
            }));
            Assert.That(readings[0].place, Is.EqualTo(new[] { 0.1, 0.0, 0.0 }));
            Assert.That((readings[4].place[1], readings[4].up[1], readings[4].length), Is.EqualTo((-0.2, 1.0, 0.4)));
            Assert.That(File.Exists(Path.Combine(folder, "readings.py")), Is.True);
        }

        [UnityTest]
        public IEnumerator ARecorderThatIsDisposedOfHandsNothingOver()
        {
            bool done = false;
            FluidExportRecorder recorder = FluidExportRecorder.Begin(new[] { simulation }, Options(), exports => done = true);
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That(recorder.Progress, Is.InRange(0.1f, 0.5f));
            recorder.Dispose();
            for (int i = 0; i < 16; i++) yield return null;

            Assert.That(done, Is.False);
            Assert.That(recorder.IsRecording, Is.False);
        }

        [UnityTest]
        public IEnumerator ARecorderHandsTheExportsOverWhenTheirTimeIsOver()
        {
            FluidSimulation other = rig.Create("Tank", position: new Vector3(5f, 0f, 0f));
            other.StopSimulation();
            FluidSimulation[] simulations = { simulation, other };
            string[] folders = FluidExport.FoldersOf(simulations, folder);
            int frames = 0, done = 0;
            FluidExportRecorder recorder = FluidExportRecorder.Begin(simulations, Options(), exports =>
            {
                done++;
                for (int i = 0; i < exports.Count; i++) exports[i].Write(folders[i]);
            });
            while (done == 0 && frames++ < 100) yield return null;
            for (int i = 0; i < 3; i++) yield return null;

            Assert.That(done, Is.EqualTo(1));
            Assert.That(frames, Is.InRange(8, 11), "an eighth of a second at 64 frames a second");
            Assert.That((recorder.IsRecording, recorder.Progress), Is.EqualTo((false, 1f)));
            Assert.That(folders.Select(Path.GetFileName), Is.EqualTo(new[] { "Tank", "Tank-2" }));
            Assert.That(folders.All(f => File.Exists(Path.Combine(f, "manifest.json"))), Is.True);
        }
    }
}
