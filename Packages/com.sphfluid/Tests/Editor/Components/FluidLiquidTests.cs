using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What a liquid sets in a simulation and its components, and what they set besides it.</summary>
    public sealed class FluidLiquidTests
    {
        private SimulationRig rig;
        private FluidSimulation simulation;
        private FluidLiquid honey, water;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            simulation = rig.Create("Tank");
            honey = PackageAssets.Liquid("Honey");
            water = PackageAssets.Liquid("Water");
        }

        [TearDown]
        public void TearDown() => rig.Dispose();

        [Test]
        public void WithoutALiquidTheProfileAndTheOwnLookAct()
        {
            var view = simulation.gameObject.AddComponent<FluidSurfaceRenderer>();
            view.Look = FluidSurfaceLook.Opaque;
            Assert.That(simulation.ActiveLiquid, Is.Null);
            Assert.That(simulation.Spec.Profile.Asset, Is.EqualTo(rig.Profile));
            Assert.That(view.ActiveLook, Is.EqualTo(FluidSurfaceLook.Opaque));
        }

        [Test]
        public void ALiquidGivesMotionStartAndLook()
        {
            var view = simulation.gameObject.AddComponent<FluidSurfaceRenderer>();
            view.Look = FluidSurfaceLook.Opaque;
            FluidLiquid packed = Copy(honey);
            packed.StartRelaxation = FluidStartRelaxation.Packed;
            simulation.Profile = null;
            simulation.Liquid = packed;
            Assert.That(simulation.Profile, Is.EqualTo(honey.Profile));
            Assert.That(simulation.Spec.Profile.Rules.RestDensity, Is.EqualTo(1420f));
            Assert.That(simulation.Spec.StartRelaxation, Is.EqualTo(FluidStartRelaxation.Packed));
            simulation.StartRelaxation = FluidStartRelaxation.Hydrostatic;
            Assert.That(simulation.Spec.StartRelaxation, Is.EqualTo(FluidStartRelaxation.Hydrostatic));
            Assert.That(view.ActiveLook, Is.EqualTo(FluidSurfaceLook.Water));
            Assert.That(view.WaterShadow, Is.EqualTo(honey.Water.Shadow));
            view.OwnLook = true;
            Assert.That(view.ActiveLook, Is.EqualTo(FluidSurfaceLook.Opaque));
            Object.DestroyImmediate(packed);
        }

        [Test]
        public void AnotherLiquidIsAnotherStartAndAnotherLookIsNot()
        {
            simulation.Profile = null;
            simulation.Liquid = water;
            FluidStartKey before = FluidStartKey.Create(simulation.Spec);
            FluidLiquid blue = Copy(water);
            blue.Water.ColorAtOneMetre = Color.blue;
            simulation.Liquid = blue;
            Assert.That(FluidStartKey.Create(simulation.Spec).Equals(before));
            simulation.Liquid = honey;
            Assert.That(FluidStartKey.Create(simulation.Spec).Equals(before), Is.False);
            Object.DestroyImmediate(blue);
        }

        [Test]
        public void AProfileOfItsOwnActsAndTheInspectorSaysSo()
        {
            simulation.Liquid = honey;
            Assert.That(simulation.Spec.Profile.Asset, Is.EqualTo(rig.Profile));
            FluidMessage said = Contradictions().Single();
            Assert.That(said.ToString(), Does.Contain("'Honey'").And.Contain("'Test Water'"));
            FluidFix.For(said, simulation).Value.Apply();
            Assert.That(simulation.Spec.Profile.Asset, Is.EqualTo(honey.Profile));
            Assert.That(Contradictions(), Is.Empty);
        }

        [Test]
        public void ALookOfItsOwnIsNamedWithACure()
        {
            simulation.Profile = null;
            simulation.Liquid = honey;
            var view = simulation.gameObject.AddComponent<FluidSurfaceRenderer>();
            Assert.That(Contradictions(), Is.Empty);
            view.OwnLook = true;
            FluidMessage said = Contradictions().Single();
            Assert.That(said.Context, Is.EqualTo(view));
            FluidFix.For(said, simulation).Value.Apply();
            Assert.That(view.OwnLook, Is.False);
        }

        [Test]
        public void AnEmitterGivesItsLiquidToASimulationWithoutOne()
        {
            simulation.Profile = null;
            FluidEmitter tap = Emitter("Tap");
            tap.Liquid = honey;
            Assert.That(simulation.Spec.Profile.Asset, Is.EqualTo(honey.Profile));
            Assert.That(simulation.ActiveLiquid, Is.EqualTo(honey));
            Assert.That(simulation.Validate().Select(m => m.ToString()), Is.Empty);
        }

        [Test]
        public void AnEmitterOfAnotherLiquidIsNamedWithTheSimulationAndACure()
        {
            simulation.Profile = null;
            simulation.Liquid = water;
            FluidEmitter tap = Emitter("Tap");
            tap.Liquid = water;
            Assert.That(simulation.Validate().Select(m => m.ToString()), Is.Empty);
            tap.Liquid = honey;
            FluidMessage said = simulation.Validate().Single();
            Assert.That(said.Issue, Is.EqualTo(FluidIssue.LiquidsDiffer));
            Assert.That(said.ToString(), Does.Contain("'Tap'").And.Contain("'Tank'").And.Contain("'Honey'").And.Contain("'Water'"));
            FluidFix.For(said, simulation).Value.Apply();
            Assert.That(tap.Liquid, Is.EqualTo(water));
        }

        [Test]
        public void TheInspectorOfALiquidDraws() => InspectorDrawing.Draw(honey, water);

        private List<FluidMessage> Contradictions()
        {
            var messages = new List<FluidMessage>();
            LiquidRules.Check(simulation, messages);
            return messages;
        }

        private FluidEmitter Emitter(string name)
        {
            GameObject holder = rig.NewObject(name);
            holder.transform.SetParent(simulation.transform, false);
            holder.transform.localPosition = 0.15f * Vector3.up;
            return holder.AddComponent<FluidEmitter>();
        }

        private static FluidLiquid Copy(FluidLiquid liquid) => Object.Instantiate(liquid);
    }
}
