using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>
    /// Each wrong input is one message that names the object and the cure; nothing crashes, nothing is skipped in silence.
    /// </summary>
    public sealed class BadInputTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator MissingProfile()
        {
            FluidSimulation simulation = rig.Create();
            simulation.Profile = null;
            LogAssert.Expect(LogType.Error, new Regex(@"\[SPH Fluid\] 'Fluid': No liquid is assigned\. Assign a Fluid Liquid"));
            yield return null;
            yield return null;
            yield return null;
            Assert.That(simulation.IsRunning, Is.False);
            simulation.Profile = rig.Profile;
            yield return null;
            yield return null;
            Assert.That(simulation.IsRunning, simulation.StatusMessage);
        }

        [Test]
        public void MissingShaders()
        {
            rig.Profile.Shaders = null;
            Fails(rig.Create(), FluidIssue.ShadersMissing, "'Test Water': The profile has no shader set");

            var set = ScriptableObject.CreateInstance<FluidShaderSet>();
            set.name = "Half Set";
            rig.Profile.Shaders = set;
            FluidSimulation simulation = rig.Create();
            simulation.Method = FluidMethodKind.Thesis;
            Fails(simulation, FluidIssue.ShadersMissing, "'Half Set': The shader set has no .*BitonicSort");
            simulation.Method = FluidMethodKind.Standard;
            Fails(simulation, FluidIssue.ShadersMissing, "'Half Set': The shader set has no .*MoveParticles");
            Object.DestroyImmediate(set);
        }

        [Test]
        public void UnknownMethod()
        {
            FluidSimulation simulation = rig.Create();
            simulation.Method = (FluidMethodKind)77;
            Fails(simulation, FluidIssue.MethodUnknown, "'Fluid': There is no method 77");
        }

        [TestCase(0f)]
        [TestCase(-1f)]
        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void WrongDomainSize(float value)
        {
            FluidSimulation simulation = rig.Create();
            simulation.DomainSize = new Vector3(0.4f, value, 0.4f);
            Fails(simulation, FluidIssue.DomainSizeInvalid, "'Fluid': The domain size is .*greater than zero");
        }

        [TestCase(0f, "The particle spacing is 0 m.*greater than zero")]
        [TestCase(-0.1f, "The particle spacing is")]
        [TestCase(float.NaN, "The particle spacing is")]
        [TestCase(0.3f, "less than two particles of 0\\.3 m wide.*smaller Particle Spacing")]
        public void WrongSpacing(float value, string expected)
        {
            FluidSimulation simulation = rig.Create();
            simulation.Spacing = value;
            Fails(simulation, FluidIssue.SpacingInvalid, "'Fluid': .*" + expected);
        }

        [Test]
        public void WrongTimeStepAndGravity()
        {
            FluidSimulation simulation = rig.Create();
            simulation.TimeStepMode = FluidTimeStepMode.Fixed;
            simulation.FixedTimeStep = 0f;
            Fails(simulation, FluidIssue.TimeStepInvalid, "'Fluid': The fixed time step is 0 s.*Automatic");
            simulation.TimeStepMode = FluidTimeStepMode.Automatic;
            simulation.UseSceneGravity = false;
            simulation.Gravity = new Vector3(0f, float.NaN, 0f);
            Fails(simulation, FluidIssue.GravityInvalid, "'Fluid': Gravity is not a finite number");
        }

        [TestCase(0f, FluidIssue.DomainSizeInvalid, "The farthest distance is 0 × 10 × 50 m.*Give Farthest Distance")]
        [TestCase(float.NaN, FluidIssue.DomainSizeInvalid, "The farthest distance is NaN × 10 × 50 m.*Give Farthest Distance")]
        [TestCase(300f, FluidIssue.TooManyCells, "The domain of 600 × 20 × 100 m needs [0-9,]+ cells.*Use a smaller Farthest Distance")]
        public void AFarthestDistanceThatCannotBe(float value, FluidIssue issue, string expected)
        {
            FluidSimulation simulation = rig.Create();
            simulation.Domain = FluidDomain.Open;
            simulation.FarthestDistance = new Vector3(value, 10f, 50f);
            simulation.Spacing = 0.03f;
            Fails(simulation, issue, "'Fluid': " + expected);
        }

        [Test]
        public void AnOpenDomainWithFacesOfABox()
        {
            FluidSimulation simulation = rig.Create();
            simulation.Domain = FluidDomain.Open;
            simulation.FarthestDistance = Vector3.one;
            simulation.Boundaries = new FluidBoundaries { Periodic = FluidAxes.X };
            Fails(simulation, FluidIssue.BoundariesInvalid, "'Fluid': The domain is open, and has neither periodic.*Set Domain to Box");
            simulation.Boundaries = default;
            simulation.Method = FluidMethodKind.Thesis;
            Fails(simulation, FluidIssue.BoundariesInvalid, "'Fluid': The domain is open, but the method Thesis keeps.*Set Domain to Box");
            simulation.Method = FluidMethodKind.Standard;
            Assert.That(simulation.Validate().Where(m => m.Severity == FluidSeverity.Error), Is.Empty);
        }

        [Test]
        public void UnstableTimeStepIsAWarningWithTheLimit()
        {
            FluidSimulation simulation = rig.Create();
            simulation.TimeStepMode = FluidTimeStepMode.Fixed;
            simulation.FixedTimeStep = 0.1f;
            FluidMessage message = simulation.Validate().Single();
            Assert.That(message.Issue, Is.EqualTo(FluidIssue.TimeStepInvalid));
            Assert.That(message.Severity, Is.EqualTo(FluidSeverity.Warning));
            Assert.That(message.Text, Does.Contain("100 ms").And.Contain("stability limit"));
        }

        [Test]
        public void UnstableTimeStepNamesWhatLimitsIt()
        {
            FluidSimulation simulation = rig.Create();
            simulation.Method = FluidMethodKind.Thesis;
            simulation.TimeStepMode = FluidTimeStepMode.Fixed;
            simulation.FixedTimeStep = 0.0015f;
            Assert.That(simulation.Validate(), Is.Empty);
            rig.Profile.SupportRatio = 2f;
            rig.Profile.KinematicViscosity = 0.5f;
            FluidMessage message = simulation.Validate().Single();
            Assert.That(message.Text, Does.Contain("above the stability limit of 1.2 ms, which the kinematic viscosity (0.5 m²/s) sets"),
                "0.06 · 0.1² / 0.5");
            Assert.That(message.Cure, Does.Contain("0.0012 s").Or.Contain("0.0011 s"));
            simulation.TimeStepMode = FluidTimeStepMode.Automatic;
            Assert.That(simulation.Validate(), Is.Empty);
        }

        [TestCase("across", "The wall velocity Boundaries\\.LowX is .*wall's plane\\. Set its X component to zero")]
        [TestCase("slip", "The wall velocity Boundaries\\.LowX is .*only push\\. Set Boundaries\\.Friction")]
        [TestCase("open", "The wall velocity Boundaries\\.LowX is .*X is periodic and has no walls\\. Set the velocity")]
        [TestCase("thesis", "Boundaries\\.Open has LowY, but with the method Thesis all faces are walls\\. Use the method Standard")]
        [TestCase("both", "Boundaries\\.Open has HighZ, but Boundaries\\.Periodic has Z.*\\. Take the face out of one")]
        [TestCase("belt",
            "The wall velocity Boundaries\\.HighX is .*that face is open and has no wall\\. Set the velocity to zero, or take HighX out " +
            "of Boundaries\\.Open")]
        [TestCase("short", "The domain is 0\\.4 m along X, which is periodic, .*must be 0\\.42 m or more.*\\. Enlarge")]
        [TestCase("force", "The body force's RateSquared is 1 1/s² along X, which is periodic.*\\. Set it to zero")]
        public void WrongFaces(string kind, string expected)
        {
            FluidSimulation simulation = rig.Create();
            var along = new Vector3(0f, 1f, 0f);
            switch (kind)
            {
                case "across": simulation.Boundaries = new FluidBoundaries { NoSlip = true, LowX = Vector3.one }; break;
                case "slip": simulation.Boundaries = new FluidBoundaries { LowX = along }; break;
                case "open": simulation.Boundaries = new FluidBoundaries { NoSlip = true, LowX = along, Periodic = FluidAxes.X }; break;
                case "thesis": simulation.Boundaries = new FluidBoundaries { Open = FluidFaces.LowY }; break;
                case "both": simulation.Boundaries = new FluidBoundaries { Open = FluidFaces.HighZ, Periodic = FluidAxes.Z }; break;
                case "belt": simulation.Boundaries = new FluidBoundaries { Open = FluidFaces.HighX, NoSlip = true, HighX = along }; break;
                default: simulation.Boundaries = new FluidBoundaries { Periodic = FluidAxes.X }; break;
            }
            simulation.Method = kind == "thesis" ? FluidMethodKind.Thesis : FluidMethodKind.Standard;
            if (kind == "short") rig.Profile.SupportRatio = 2.8f;
            if (kind == "force") simulation.BodyForce = new FluidBodyForce { RateSquared = Vector3.one };
            Fails(simulation, FluidIssue.BoundariesInvalid, "'Fluid': " + expected);
            Assert.That(simulation.Messages.Count, Is.EqualTo(1));
        }

        [Test]
        public void VelocityFieldWithoutNumbers()
        {
            FluidSimulation simulation = rig.Create();
            simulation.VelocityField = position => position / 0f;
            Fails(simulation, FluidIssue.StartFailed,
                "'Fluid': The velocity field gives a velocity that is not a finite number\\. Give VelocityField");
        }

        [Test]
        public void DomainWithoutLiquid() =>
            Fails(rig.Create(liquid: false), FluidIssue.NoLiquid, "'Fluid': The domain holds no liquid.*Fluid Volume");

        [TestCase(0f)]
        [TestCase(-0.2f)]
        [TestCase(float.NaN)]
        public void WrongVolumeSize(float value)
        {
            FluidSimulation simulation = rig.Create(liquid: false);
            rig.AddVolume(simulation).Size = new Vector3(0.2f, value, 0.2f);
            Fails(simulation, FluidIssue.VolumeSizeInvalid, "'Liquid': The liquid volume's size is .*greater than zero");
        }

        [Test]
        public void VolumeTooSmallForAParticle()
        {
            FluidSimulation simulation = rig.Create();
            FluidVolume speck = rig.AddVolume(simulation, "Speck");
            speck.Size = new Vector3(0.001f, 0.001f, 0.001f);
            speck.transform.localPosition = new Vector3(0.125f, 0.15f, 0.15f);
            Fails(simulation, FluidIssue.VolumeSizeInvalid, "'Speck': .*too small to hold a particle");
        }

        [Test]
        public void LiquidOutsideTheDomain()
        {
            FluidSimulation simulation = rig.Create();
            FluidVolume volume = simulation.GetComponentInChildren<FluidVolume>();
            volume.transform.localPosition = new Vector3(1f, 0f, 0f);
            Fails(simulation, FluidIssue.VolumeOutsideDomain,
                "'Liquid': The liquid volume lies outside the domain of 'Fluid'.*Domain Size");
        }

        [Test]
        public void LiquidPartlyOutsideTheDomainRunsWithAWarning()
        {
            FluidSimulation simulation = rig.Create();
            simulation.GetComponentInChildren<FluidVolume>().transform.localPosition = new Vector3(0.2f, 0f, 0f);
            LogAssert.Expect(LogType.Warning, new Regex(@"\[SPH Fluid\] 'Liquid': 50 % of the liquid volume lies outside"));
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(simulation.ParticleCount, Is.EqualTo(32));
        }

        [Test]
        public void LiquidInsideAColliderIsCarvedAndCounted()
        {
            FluidSimulation simulation = rig.Create();
            BoxCollider box = rig.NewObject("Crate").AddComponent<BoxCollider>();
            box.size = new Vector3(0.2f, 0.4f, 0.4f);
            box.transform.position = new Vector3(0.1f, 0f, 0f);
            LogAssert.Expect(LogType.Warning,
                new Regex(@"\[SPH Fluid\] 'Liquid': 32 of 64 particles would start inside colliders.*'Crate'"));
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(simulation.ParticleCount, Is.EqualTo(32));

            box.size = new Vector3(1f, 1f, 1f);
            Fails(simulation, FluidIssue.VolumeInsideCollider,
                "'Liquid': The liquid volume lies wholly inside colliders.*'Crate'.*Collider Layers");
        }

        [Test]
        public void WhatARockTakesOfAPoolIsInformation()
        {
            FluidSimulation simulation = rig.Create();
            BoxCollider rock = rig.NewObject("Rock").AddComponent<BoxCollider>();
            rock.size = new Vector3(0.4f, 0.02f, 0.02f);
            rock.transform.position = new Vector3(0f, 0.025f, 0.025f);
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(simulation.ParticleCount, Is.EqualTo(60));
            Assert.That(simulation.Messages.Single().Issue, Is.EqualTo(FluidIssue.VolumeInsideCollider));
            Assert.That(simulation.Messages.Single().Severity, Is.EqualTo(FluidSeverity.Info));
        }

        [Test]
        public void OverlappingVolumesAreFilledOnceAndReportedAsInformation()
        {
            FluidSimulation simulation = rig.Create();
            rig.AddVolume(simulation, "Again").transform.localPosition = new Vector3(0.1f, 0f, 0f);
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(simulation.ParticleCount, Is.EqualTo(96));
            Assert.That(simulation.Messages.Single().Issue, Is.EqualTo(FluidIssue.VolumesOverlap));
            Assert.That(simulation.Messages.Single().Severity, Is.EqualTo(FluidSeverity.Info));
        }

        [Test]
        public void MoreParticlesThanTheCap()
        {
            rig.Profile.MaxParticles = 60;
            Fails(rig.Create(), FluidIssue.TooManyParticles,
                @"'Fluid': The liquid needs 64 particles at a spacing of 0\.05 m, but the profile 'Test Water' allows 60.*Particle " +
                @"Spacing of 0\.05\d* m or more");
        }

        [TestCase(400f, FluidMethodKind.Standard, "holds")]
        [TestCase(400f, FluidMethodKind.Thesis, "holds")]
        public void MoreCellsThanTheBudget(float size, FluidMethodKind method, string owner)
        {
            FluidSimulation simulation = rig.Create();
            simulation.Method = method;
            simulation.DomainSize = size * Vector3.one;
            string pattern =
                $"'Fluid': The domain of {size} × {size} × {size} m needs [0-9,]+ cells for the neighbour search at a spacing of 0\\.05 " +
                $"m, but .*{owner}.*" +
                "Use a smaller Domain Size, or a Particle Spacing of 0\\.[0-9]+ m or more";
            Fails(simulation, FluidIssue.TooManyCells, pattern);
            simulation.Spacing = CellChecks.FittingSpacing(simulation.Spec);
            Assert.That(simulation.Validate().Select(m => m.Issue), Has.No.Member(FluidIssue.TooManyCells));
        }

        [TestCase(64, true)]
        [TestCase(63, false)]
        [TestCase(1, false)]
        public void TheCapHoldsItsNumberAndNoMore(int cap, bool starts)
        {
            rig.Profile.MaxParticles = cap;
            FluidSimulation simulation = rig.Create();
            if (!starts) LogAssert.Expect(LogType.Error, new Regex(@"\[SPH Fluid\] 'Fluid': The liquid needs 64 particles"));
            Assert.That(simulation.StartSimulation(), Is.EqualTo(starts));
            Assert.That(simulation.ParticleCount, Is.EqualTo(starts ? 64 : 0));
        }

        [Test]
        public void FarMoreParticlesThanAnyMachineHoldsAreCountedNotMade()
        {
            FluidSimulation simulation = rig.Create();
            simulation.Spacing = 1e-4f;
            simulation.Method = FluidMethodKind.Standard;
            LogAssert.Expect(LogType.Error,
                new Regex(
                    @"\[SPH Fluid\] 'Fluid': The liquid needs 8\d{9} particles at a spacing of 0\.0001 m, but the profile 'Test Water' " +
                    @"allows 1048576 particles, and this device's buffers hold \d+\..*Particle Spacing of 0\.00\d+ m or more"));
            LogAssert.Expect(LogType.Error, new Regex(@"\[SPH Fluid\] 'Fluid': The domain .* cells"));
            Assert.That(simulation.StartSimulation(), Is.False);
            Assert.That(simulation.Messages.Select(m => m.Issue),
                Is.EqualTo(new[] { FluidIssue.TooManyParticles, FluidIssue.TooManyCells }));
            Assert.That(simulation.GpuBytes, Is.Zero);
        }

        [Test]
        public void ScaledSimulation()
        {
            FluidSimulation simulation = rig.Create();
            simulation.transform.localScale = new Vector3(1f, 2f, 1f);
            Fails(simulation, FluidIssue.TransformScaled, "'Fluid': The transform's scale is 1 × 2 × 1.*Domain Size");
            simulation.transform.localScale = Vector3.one;
            simulation.transform.rotation = Quaternion.Euler(10f, 20f, 30f);
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
        }

        [Test]
        public void MeshesThatCannotServe()
        {
            FluidSimulation simulation = rig.Create();
            rig.NewObject("Bare Rock").AddComponent<MeshCollider>();
            LogAssert.Expect(LogType.Warning, new Regex(@"\[SPH Fluid\] 'Bare Rock': The Mesh Collider has no mesh.*Assign a mesh"));
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(simulation.Messages.Single().Issue, Is.EqualTo(FluidIssue.MeshEmpty));
        }

        [Test]
        public void FlattenedCollider()
        {
            FluidSimulation simulation = rig.Create();
            BoxCollider box = rig.NewObject("Flat").AddComponent<BoxCollider>();
            box.transform.localScale = new Vector3(0.1f, 0f, 0.1f);
            var messages = simulation.Validate();
            if (messages.Count == 0) Assert.Ignore("The physics scene does not return a collider of no height.");
            Assert.That(messages.Single().Issue, Is.EqualTo(FluidIssue.ColliderTransformSingular));
            Assert.That(messages.Single().ToString(), Does.StartWith("[SPH Fluid] 'Flat'"));
        }

        [Test]
        public void VolumeBetweenTwoSimulationsBelongsToTheOneThatHoldsIt()
        {
            FluidSimulation left = rig.Create("Left", liquid: false), right = rig.Create("Right", position: new Vector3(3f, 0f, 0f));
            FluidVolume loose = rig.NewObject("Loose").AddComponent<FluidVolume>();
            loose.Size = new Vector3(0.1f, 0.1f, 0.1f);
            Assert.That(FluidScene.FindVolumes(left), Is.EqualTo(new[] { loose }));
            loose.transform.position = new Vector3(3f, 0f, 0f);
            Assert.That(FluidScene.FindVolumes(left), Is.Empty);
            Assert.That(FluidScene.FindVolumes(right), Has.Member(loose));
            loose.Simulation = left;
            Assert.That(FluidScene.FindVolumes(left), Is.EqualTo(new[] { loose }));
        }

        private static void Fails(FluidSimulation simulation, FluidIssue issue, string pattern)
        {
            LogAssert.Expect(LogType.Error, new Regex(@"\[SPH Fluid\] " + pattern));
            Assert.That(simulation.StartSimulation(), Is.False);
            Assert.That(simulation.Messages[0].Issue, Is.EqualTo(issue));
            Assert.That(simulation.Messages[0].Cure, Is.Not.Empty);
            Assert.That(simulation.GpuBytes, Is.Zero);
            simulation.StopSimulation();
        }
    }
}
