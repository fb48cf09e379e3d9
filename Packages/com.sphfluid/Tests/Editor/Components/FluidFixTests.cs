using System.Linq;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The inspector's buttons cure what the message says, and can be undone.</summary>
    public sealed class FluidFixTests
    {
        private FluidSimulation simulation;

        [SetUp]
        public void SetUp()
        {
            simulation = new GameObject("Fluid").AddComponent<FluidSimulation>();
            simulation.ColliderLayers = 0;
            simulation.Profile = AssetDatabase.LoadAssetAtPath<FluidProfile>("Packages/com.sphfluid/Runtime/Assets/WaterProfile.asset");
            var volume = new GameObject("Liquid").AddComponent<FluidVolume>();
            volume.transform.SetParent(simulation.transform, false);
        }

        [TearDown]
        public void TearDown() => Object.DestroyImmediate(simulation.gameObject);

        [Test]
        public void AGoodSetUpHasNoMessages() => Assert.That(simulation.Validate().Select(m => m.ToString()), Is.Empty);

        [Test]
        public void MissingProfile()
        {
            simulation.Profile = null;
            Cure(FluidIssue.ProfileMissing);
            Assert.That(simulation.Profile.name, Is.EqualTo("WaterProfile"));
        }

        [Test]
        public void WrongDomainSize()
        {
            simulation.DomainSize = new Vector3(-2f, 0f, 1f);
            Cure(FluidIssue.DomainSizeInvalid);
            Assert.That(simulation.DomainSize, Is.EqualTo(new Vector3(2f, 1f, 1f)));
        }

        [Test]
        public void WrongSpacing()
        {
            simulation.Spacing = 0f;
            Cure(FluidIssue.SpacingInvalid);
            Assert.That(simulation.Spacing, Is.EqualTo(1f / 40f));
        }

        [Test]
        public void ScaledTransform()
        {
            simulation.transform.localScale = new Vector3(2f, 2f, 2f);
            Cure(FluidIssue.TransformScaled);
            Assert.That(simulation.transform.lossyScale, Is.EqualTo(Vector3.one));
        }

        [Test]
        public void TooManyParticles()
        {
            FluidProfile small = Object.Instantiate(simulation.Profile);
            small.MaxParticles = 1000;
            simulation.Profile = small;
            Cure(FluidIssue.TooManyParticles);
            Assert.That(simulation.Spacing, Is.EqualTo(0.05f).Within(5).Percent);
            Object.DestroyImmediate(small);
        }

        [Test]
        public void TooManyCells()
        {
            simulation.Method = FluidMethodKind.Standard;
            simulation.DomainSize = new Vector3(200f, 50f, 200f);
            simulation.Spacing = 0.02f;
            Cure(FluidIssue.TooManyCells);
        }

        [Test]
        public void AnOpenDomain()
        {
            simulation.Domain = FluidDomain.Open;
            simulation.FarthestDistance = new Vector3(-3f, 2f, 2f);
            Cure(FluidIssue.DomainSizeInvalid);
            Assert.That(simulation.FarthestDistance, Is.EqualTo(new Vector3(3f, 2f, 2f)));
            simulation.Boundaries = new FluidBoundaries { Periodic = FluidAxes.X };
            Cure(FluidIssue.BoundariesInvalid);
            Assert.That(simulation.Domain, Is.EqualTo(FluidDomain.Box));
        }

        [Test]
        public void WrongFacesAndForces()
        {
            simulation.BodyForce = new FluidBodyForce { RateSquared = Vector3.one };
            simulation.Boundaries = new FluidBoundaries { NoSlip = true, LowY = new Vector3(0f, 1f, 0f) };
            Cure(FluidIssue.BoundariesInvalid);
            Assert.That(simulation.Boundaries.IsDefault);
            Assert.That(simulation.BodyForce.IsOn, "the force was not at fault");
            simulation.Boundaries = new FluidBoundaries { Periodic = FluidAxes.X };
            Cure(FluidIssue.BoundariesInvalid);
            Assert.That(simulation.BodyForce.IsOn, Is.False);
            Assert.That(simulation.Boundaries.Periodic, Is.EqualTo(FluidAxes.X), "the faces were not at fault");
        }

        [Test]
        public void NoLiquid()
        {
            Object.DestroyImmediate(simulation.GetComponentInChildren<FluidVolume>().gameObject);
            Cure(FluidIssue.NoLiquid);
            Assert.That(simulation.GetComponentsInChildren<FluidVolume>().Length, Is.EqualTo(1));
        }

        [Test]
        public void FixesCanBeUndone()
        {
            simulation.Spacing = -1f;
            Undo.IncrementCurrentGroup();
            Cure(FluidIssue.SpacingInvalid);
            Undo.PerformUndo();
            Assert.That(simulation.Spacing, Is.EqualTo(-1f));
        }

        [Test]
        public void MenuMakesAWorkingSetUp()
        {
            FluidMenu.CreateWithParticles(new MenuCommand(null));
            GameObject made = Selection.activeGameObject;
            try
            {
                var created = made.GetComponent<FluidSimulation>();
                Assert.That(made.GetComponent<FluidParticleRenderer>(), Is.Not.Null);
                created.ColliderLayers = 0;
                Assert.That(created.Validate().Select(m => m.ToString()), Is.Empty);
            }
            finally
            {
                Object.DestroyImmediate(made);
            }
        }

        private void Cure(FluidIssue issue)
        {
            FluidMessage message = simulation.Validate().First(m => m.Issue == issue);
            FluidFix? fix = FluidFix.For(message, simulation);
            Assert.That(fix.HasValue, message.ToString());
            fix.Value.Apply();
            Assert.That(simulation.Validate().Select(m => m.ToString()), Is.Empty);
        }
    }
}
