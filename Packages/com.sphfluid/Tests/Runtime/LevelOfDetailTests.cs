using System.Collections;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A liquid far from every camera is worth less, and says so.</summary>
    public sealed class LevelOfDetailTests
    {
        private SimulationRig rig;
        private FluidSimulation simulation;
        private FluidLevelOfDetail detail;
        private Camera camera;
        private RenderTexture picture;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(1f / 60f);
            simulation = rig.Create();
            detail = simulation.gameObject.AddComponent<FluidLevelOfDetail>();
            detail.UseLodBias = false;
            detail.Levels.Clear();
            detail.Levels.Add(new FluidDetailLevel { Distance = 10f, StepFactor = 1.5f, CellFactor = 1.5f });
            detail.Levels.Add(new FluidDetailLevel { Distance = 20f, StepFactor = 2f, CellFactor = 2f, Drawn = false, Whitewater = false });
            picture = new RenderTexture(8, 8, 16);
            camera = NewCamera("Main", 1f);
        }

        [UnityTearDown]
        public IEnumerator TearDown()
        {
            rig.Dispose();
            Object.DestroyImmediate(picture);
            yield return Frames(16); // temporary textures of the screen are kept for 15
        }

        [UnityTest]
        public IEnumerator FarLiquidTakesLongerStepsAndComesBack()
        {
            yield return Frames(30);
            float sound = simulation.Solver.Settings.SoundSpeed, step = simulation.TimeStep;
            FluidSolver solver = simulation.Solver;
            rig.Profile.SoundSpeedMode = FluidSoundSpeedMode.FixedByRule; // so that only the level changes it
            yield return null;
            sound = simulation.Solver.Settings.SoundSpeed;
            Far(30f);
            yield return Frames(10);
            Assert.That(simulation.Solver.Settings.SoundSpeed, Is.InRange(0.85f * sound, 0.95f * sound), "on its way, e^(-1/12)");
            yield return Frames(100);
            Assert.That(simulation.Solver.Settings.SoundSpeed, Is.EqualTo(0.5f * sound).Within(0.01f * sound));
            long far = simulation.StepCount;
            yield return Frames(30);
            far = simulation.StepCount - far;
            Far(1f);
            yield return Frames(100);
            Assert.That(simulation.Solver.Settings.SoundSpeed, Is.EqualTo(sound));
            long near = simulation.StepCount;
            yield return Frames(30);
            near = simulation.StepCount - near;
            Assert.That(near, Is.GreaterThan(1.4 * far), $"{far} steps far away");
            Assert.That(simulation.Solver, Is.SameAs(solver), "nothing starts again");
        }

        [UnityTest]
        public IEnumerator AFreshLiquidBeginsAtItsLevel()
        {
            rig.Profile.SoundSpeedMode = FluidSoundSpeedMode.FixedByRule;
            Far(30f);
            yield return Frames(3);
            float sound = simulation.Solver.Settings.SoundSpeed;
            Far(1f);
            yield return Frames(2);
            simulation.StartSimulation();
            Assert.That(simulation.Solver.Settings.SoundSpeed, Is.EqualTo(2f * sound).Within(0.01f * sound));
        }

        [UnityTest]
        public IEnumerator TheNearestCameraDecidesAndTheLevelIsToldAndShown()
        {
            int told = -1, times = 0;
            detail.LevelChanged.AddListener(level => (told, times) = (level, times + 1));
            var overlay = rig.NewObject("Overlay").AddComponent<FluidOverlay>();
            Far(15f);
            yield return Frames(3);
            Assert.That((detail.CurrentLevel, told, times), Is.EqualTo((1, 1, 1)));
            Assert.That(detail.Distance, Is.EqualTo(15f).Within(1e-4f));
            Assert.That(detail.NearestCamera, Is.SameAs(camera));
            yield return Frames(20);
            Assert.That(overlay.Text, Does.Contain("\n  detail 1 of 2: 15 m from Main\n"));
            detail.Importance = 2f;
            yield return null;
            Assert.That(detail.CurrentLevel, Is.Zero);
            detail.Importance = 0.5f;
            yield return null;
            Assert.That(detail.CurrentLevel, Is.EqualTo(2));
            Camera second = NewCamera("Second", 4f);
            yield return null;
            Assert.That((detail.CurrentLevel, detail.NearestCamera), Is.EqualTo((0, second)));
            second.cullingMask = ~(1 << SimulationRig.Layer);
            yield return null;
            Assert.That(detail.CurrentLevel, Is.EqualTo(2), "it does not draw the liquid's layer");
            detail.Cameras.Add(second);
            yield return null;
            Assert.That(detail.CurrentLevel, Is.Zero, "it is named");
            second.enabled = false;
            yield return null;
            Assert.That(detail.CurrentLevel, Is.Zero, "a script may render it");
            detail.Cameras.Clear();
            (second.enabled, second.cullingMask, second.fieldOfView) = (true, -1, 5f);
            second.transform.position = Place(40f);
            yield return null;
            Assert.That(detail.CurrentLevel, Is.Zero, "40 m away through a telescope are 3 m");
            Assert.That(detail.Describe(), Is.EqualTo("all detail: 40 m from Second, as large as at 3 m"));
            float bias = QualitySettings.lodBias;
            second.gameObject.SetActive(false);
            QualitySettings.lodBias = 4f;
            detail.Importance = 1f;
            yield return null;
            int without = detail.CurrentLevel;
            detail.UseLodBias = true;
            yield return null;
            QualitySettings.lodBias = bias;
            Assert.That((without, detail.CurrentLevel), Is.EqualTo((1, 0)), "LOD Bias");
            detail.enabled = false;
            Assert.That(detail.CurrentLevel, Is.Zero);
            yield return Frames(20);
            Assert.That(overlay.Text, Does.Contain("particles").And.Not.Contain("detail"));
        }

        [UnityTest]
        public IEnumerator WithoutACameraAllDetailStaysAndThatIsSaidOnce()
        {
            Far(30f);
            yield return Frames(3);
            camera.enabled = false;
            yield return Frames(3);
            Assert.That(detail.CurrentLevel, Is.EqualTo(2), "cameras may be switched");
            yield return Frames(60);
            Assert.That(detail.CurrentLevel, Is.Zero);
            FluidMessage said = simulation.Messages.Single(m => m.Issue == FluidIssue.DetailInvalid);
            Assert.That(said.ToString(), Does.Contain("Fluid").And.Contain("Culling Mask"));
            camera.enabled = true;
            yield return null;
            Assert.That(detail.CurrentLevel, Is.EqualTo(2), "the cure cures");
        }

        [UnityTest]
        public IEnumerator NumbersThatCannotBeUsedAreSaidAndChangeNothing()
        {
            Far(30f);
            yield return Frames(2);
            detail.Levels[1].Distance = 5f;
            yield return null;
            Assert.That(detail.CurrentLevel, Is.Zero);
            FluidMessage said = simulation.Messages.Single(m => m.Issue == FluidIssue.DetailInvalid);
            Assert.That(said.ToString(), Does.Contain("level 2 is 5 m").And.Contain("greater Distance"));
            detail.Levels[1].Distance = 20f;
            yield return null;
            Assert.That(detail.CurrentLevel, Is.EqualTo(2));
        }

        [UnityTest]
        public IEnumerator WhatALevelAsksForInVainIsSaid()
        {
            detail.Levels[0].StepFactor = 1f;
            detail.Levels[1].StepFactor = 4f;
            simulation.StartSimulation();
            Assert.That(Limited(), Does.Contain("Level 2").And.Contain("allow 2 times"));
            simulation.TimeStepMode = FluidTimeStepMode.Fixed;
            simulation.StartSimulation();
            Assert.That(Limited(), Does.Contain("Fixed"));
            simulation.TimeStepMode = FluidTimeStepMode.Automatic;
            (rig.Profile.SurfaceTension, rig.Profile.TensionAtAnySpacing) = (100f, true); // 1,400 times water's
            detail.Levels[1].StepFactor = 2f;
            simulation.StartSimulation();
            Assert.That(Limited(), Does.Contain("the surface tension allows 1."));
            rig.Profile.SurfaceTension = 0f;
            simulation.StartSimulation();
            Assert.That(simulation.Messages.Where(m => m.Issue == FluidIssue.DetailLimited), Is.Empty);
            detail.Levels[1].StepFactor = 3f;
            Far(30f);
            yield return Frames(3);
            Assert.That(Limited(), Does.Contain("allow 2 times"), "of a level that came while it runs");
        }

        [UnityTest]
        public IEnumerator TheSurfaceIsCoarserThenGoneAndComesBack()
        {
            FluidSurfaceRenderer view = simulation.gameObject.AddComponent<FluidSurfaceRenderer>();
            FluidWhitewater whitewater = simulation.gameObject.AddComponent<FluidWhitewater>();
            var mesh = rig.NewObject("Mesh").AddComponent<FluidSurfaceMesh>();
            MeshRenderer unseen = mesh.gameObject.AddComponent<MeshRenderer>();
            (unseen.sharedMaterial, unseen.enabled) = (new Material(rig.Profile.Shaders.Find("SPH Fluid/Surface")), false);
            mesh.Simulation = simulation;
            yield return Frames(3);
            simulation.Paused = true;
            yield return Frames(5);
            long full = view.Status.Triangles;
            Far(12f);
            yield return Frames(8);
            long coarse = view.Status.Triangles;
            Assert.That(coarse, Is.InRange(0.4 * full, 0.75 * full), "8 cells in place of 11 along an edge");
            Assert.That(mesh.Status.Triangles, Is.EqualTo(coarse), "as a mesh");
            Assert.That(whitewater.GpuBytes, Is.Not.Zero);
            simulation.Paused = false;
            Far(30f);
            yield return Frames(2);
            int made = view.Recordings;
            yield return Frames(4);
            Assert.That(view.Recordings, Is.EqualTo(made), "nothing is made");
            Assert.That(whitewater.GpuBytes, Is.Zero);
            Assert.That(mesh.GetComponent<MeshFilter>().sharedMesh == null);
            Far(1f);
            yield return Frames(8);
            Assert.That(view.Recordings, Is.GreaterThan(made));
            Assert.That(view.Status.Triangles, Is.GreaterThan(1.5 * coarse));
            Object.DestroyImmediate(unseen.sharedMaterial);
            Object.DestroyImmediate(mesh.gameObject);
            detail.Levels[0].CellFactor = 4f;
            Far(12f);
            yield return Frames(2);
            Assert.That(Limited(), Does.Contain("cells 4 times as large; they are 2.67 times"));
        }

        [UnityTest]
        public IEnumerator APausedLevelStopsTheLiquidsTime()
        {
            detail.Levels[1].Paused = true;
            yield return Frames(3);
            Far(30f);
            yield return null;
            (long steps, double time) = (simulation.StepCount, simulation.SimulatedTime);
            yield return Frames(5);
            Assert.That((simulation.StepCount, simulation.SimulatedTime), Is.EqualTo((steps, time)));
            Far(1f);
            yield return null;
            Assert.That(simulation.SimulatedTime - time, Is.EqualTo(1.0 / 60.0).Within(1e-6), "no time is made up for");
        }

        // At once the same pool gets 20 times the energy.
        [UnityTest]
        public IEnumerator APoolSwingsLittleWhenALevelBeginsAndEnds([Values(FluidMethodKind.Standard, FluidMethodKind.Robust)]
            FluidMethodKind method)
        {
            Pool(method);
            rig.Profile.Substeps = 8;
            yield return Frames(100);
            double most = 0.0;
            for (int frame = 0; frame < 200; frame++)
            {
                if (frame % 100 == 0) Far(frame == 0 ? 30f : 1f);
                yield return null;
                if (frame % 4 == 0) most = System.Math.Max(most, SimulationRig.Read(simulation).Average(p => 0.5 * p.VelT0.sqrMagnitude));
            }
            Assert.That(most, Is.LessThan(0.005 * 9.81 * 0.6), "J/kg, of its fall by its depth");
        }

        [UnityTest]
        public IEnumerator LiquidThatSleepsGoesOnSleeping()
        {
            simulation.DomainSize = new Vector3(0.3f, 0.3f, 0.18f);
            simulation.Spacing = 0.03f;
            FluidVolume water = simulation.GetComponentInChildren<FluidVolume>();
            water.Size = new Vector3(0.3f, 0.18f, 0.18f);
            water.transform.localPosition = 0.06f * Vector3.down;
            Time.captureDeltaTime = 0.02f;
            for (int frame = 0; frame < 900 && !simulation.IsAsleep; frame++) yield return null;
            Assert.That(simulation.IsAsleep);
            long steps = simulation.StepCount;
            Far(30f);
            yield return Frames(5);
            Assert.That(detail.CurrentLevel, Is.EqualTo(2));
            Far(1f);
            yield return Frames(5);
            Assert.That((simulation.IsAsleep, simulation.StepCount), Is.EqualTo((true, steps)));
        }

        [UnityTest]
        public IEnumerator ASaveGoesOnAsSoftAsItWas()
        {
            Far(30f);
            yield return Frames(30);
            using (var save = new MemoryStream())
            {
                simulation.Save(save);
                var ends = new FluidParticle[2][];
                float sound = simulation.Solver.Settings.SoundSpeed;
                for (int turn = 0; turn < 2; turn++)
                {
                    if (turn == 1)
                    {
                        Far(1f);
                        yield return Frames(100);
                        Assert.That(simulation.Solver.Settings.SoundSpeed, Is.Not.EqualTo(sound));
                        Far(30f);
                        save.Position = 0;
                        Assert.That(simulation.Restore(save), Is.True);
                        Assert.That(simulation.Solver.Settings.SoundSpeed, Is.EqualTo(sound));
                    }
                    yield return Frames(10);
                    ends[turn] = SimulationRig.Read(simulation);
                }
                Assert.That(ends[1], Is.EqualTo(ends[0]), "bit by bit");
            }
        }

        [UnityTest]
        public IEnumerator ARecordingIsReplayedFromAnyDistance()
        {
            detail.Levels[0].Paused = true;
            Far(30f);
            yield return Frames(30);
            using (var stream = new MemoryStream())
            {
                using (var recording = new FluidRecording(simulation, stream)) yield return Frames(12);
                Assert.That(Limited(), Does.Contain("recorded"));
                stream.Position = 0;
                Far(12f);
                using (var replay = new FluidReplay(simulation, stream))
                {
                    while (replay.IsPlaying) yield return null;
                    Assert.That((replay.FrameCount, replay.FirstDifference), Is.EqualTo((12, -1)));
                }
            }
        }

        [UnityTest]
        public IEnumerator InAnOpenDomainTheBoxIsAskedForAndCounts()
        {
            simulation.Domain = FluidDomain.Open;
            simulation.FarthestDistance = 40f * Vector3.one;
            Far(30f);
            yield return Frames(4);
            Assert.That(detail.CurrentLevel, Is.Zero);
            Assert.That(simulation.Messages.Single(m => m.Issue == FluidIssue.DetailInvalid).Text, Does.Contain("Farthest Distance"));
            detail.Size = Vector3.one;
            yield return null;
            Assert.That(detail.CurrentLevel, Is.EqualTo(2));
        }

        private void Pool(FluidMethodKind method)
        {
            simulation.Method = method;
            simulation.Spacing = 0.04f;
            simulation.DomainSize = new Vector3(0.2f, 0.9f, 0.2f);
            simulation.SleepsAtRest = false;
            FluidVolume water = simulation.GetComponentInChildren<FluidVolume>();
            water.Size = new Vector3(0.2f, 0.6f, 0.2f);
            water.transform.localPosition = 0.15f * Vector3.down;
        }

        private string Limited() => simulation.Messages.Single(m => m.Issue == FluidIssue.DetailLimited).Text;

        private void Far(float distance) => camera.transform.position = Place(distance);

        // From the face of the domain.
        private static Vector3 Place(float distance) => (0.2f + distance) * Vector3.back;

        private Camera NewCamera(string name, float distance)
        {
            var made = rig.NewObject(name).AddComponent<Camera>();
            made.fieldOfView = 60f;
            made.targetTexture = picture;
            made.transform.position = Place(distance);
            return made;
        }

        private static IEnumerator Frames(int count)
        {
            for (int frame = 0; frame < count; frame++) yield return null;
        }
    }
}
