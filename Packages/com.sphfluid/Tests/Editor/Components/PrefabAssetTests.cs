using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>A simulation in a prefab: as an asset, which no scene holds, and in the scene in which a prefab is edited.</summary>
    public sealed class PrefabAssetTests
    {
        private const string Path = "Packages/com.sphfluid/Tests/Editor/Components/FluidTank.prefab";

        private GameObject contents;

        [TearDown]
        public void Close()
        {
            if (contents != null) PrefabUtility.UnloadPrefabContents(contents);
        }

        [Test]
        public void AnAssetIsSaidToBeCheckedInAScene()
        {
            FluidSimulation asset = Asset();
            FluidMessage message = asset.Validate().Single();
            Assert.That(message.Issue, Is.EqualTo(FluidIssue.PrefabAsset));
            Assert.That(message.Severity, Is.EqualTo(FluidSeverity.Info));
            Assert.That(message.ToString(), Does.Contain("'FluidTank'").And.Contain("Place it in a scene"));
        }

        [Test]
        public void WrongSettingsOfAnAssetAreNamed()
        {
            FluidSimulation asset = Asset();
            float spacing = asset.Spacing;
            try
            {
                asset.Spacing = -1f;
                Assert.That(asset.Validate().Select(m => m.Issue), Is.EqualTo(new[] { FluidIssue.SpacingInvalid }));
            }
            finally
            {
                asset.Spacing = spacing;
            }
        }

        [Test]
        public void TheLiquidOfAnAssetCannotBeMeasured()
        {
            var thrown = Assert.Throws<InvalidOperationException>(() => Asset().SpacingForParticleCount(1000));
            Assert.That(thrown.Message, Does.Contain("'FluidTank'").And.Contain("prefab asset").And.Contain("Place it"));
        }

        [Test]
        public void AnAssetDoesNotStart()
        {
            UnityEngine.TestTools.LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("A prefab asset cannot run"));
            Assert.That(Asset().StartSimulation(), Is.False);
        }

        [Test]
        public void EveryInspectorOfAnAssetDraws()
        {
            foreach (MonoBehaviour component in Asset().transform.root.GetComponentsInChildren<MonoBehaviour>(true))
            {
                InspectorDrawing.Draw(component);
            }
        }

        [Test]
        public void EveryInspectorOfAnOpenPrefabDraws()
        {
            foreach (MonoBehaviour component in Open().GetComponentsInChildren<MonoBehaviour>(true)) InspectorDrawing.Draw(component);
        }

        [Test]
        public void AnOpenPrefabIsCheckedLikeAScene()
        {
            FluidSimulation opened = Open().GetComponent<FluidSimulation>();
            Assert.That(SceneObjects.All<FluidSimulation>(), Has.No.Member(opened));
            Assert.That(opened.Validate().Select(m => m.ToString()), Is.Empty);
            Assert.That(FluidScene.FindVolumes(opened).Select(v => v.name), Is.EqualTo(new[] { "Liquid" }));
            Assert.That(ViewRules.Check(opened), Is.Null);
            Assert.That(opened.SpacingForParticleCount(1000), Is.EqualTo(0.05f).Within(1e-3f));
        }

        [Test]
        public void AMeshColliderOfAnOpenPrefabIsFound()
        {
            FluidSimulation opened = Open().GetComponent<FluidSimulation>();
            opened.gameObject.AddComponent<MeshCollider>();
            Assert.That(opened.Validate().Select(m => m.Issue), Is.EqualTo(new[] { FluidIssue.MeshEmpty }));
        }

        [Test]
        public void AnOpenPrefabAndTheLoadedScenesDoNotMix()
        {
            FluidSimulation opened = Open().GetComponent<FluidSimulation>();
            var outside = new GameObject("Outside").AddComponent<FluidSimulation>();
            var loose = new GameObject("Loose").AddComponent<FluidVolume>();
            try
            {
                Assert.That(FluidScene.FindVolumes(outside), Is.EqualTo(new[] { loose }));
                Assert.That(FluidScene.FindVolumes(opened), Has.No.Member(loose));
            }
            finally
            {
                Object.DestroyImmediate(loose.gameObject);
                Object.DestroyImmediate(outside.gameObject);
            }
        }

        private static FluidSimulation Asset()
        {
            var prefab = AssetDatabase.LoadAssetAtPath<GameObject>(Path);
            Assert.That(prefab, Is.Not.Null, Path);
            Assert.That(prefab.scene.IsValid(), Is.False);
            return prefab.GetComponent<FluidSimulation>();
        }

        private GameObject Open() => contents = PrefabUtility.LoadPrefabContents(Path);
    }
}
