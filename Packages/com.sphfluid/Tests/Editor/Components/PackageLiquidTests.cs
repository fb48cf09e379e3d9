using System.IO;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The liquids that the package brings: each is whole, has a menu entry, a prefab and a picture.</summary>
    public sealed class PackageLiquidTests
    {
        private const string Folder = "Packages/com.sphfluid/Runtime/Assets/Liquids";
        private const int MostBytes = 40000, LargestPicture = 256;

        private static readonly string[] Names =
        {
            "Blood", "Honey", "Lava", "Mercury", "Milk", "Muddy River", "Oil", "Sea Water", "Slime", "Water",
        };

        [SetUp]
        public void SetUp() => EditorSceneManager.NewScene(NewSceneSetup.EmptyScene);

        [TearDown]
        public void TearDown() => EditorSceneManager.NewScene(NewSceneSetup.EmptyScene);

        [Test]
        public void TheyAreTen() =>
            Assert.That(Directory.GetFiles(Path.GetFullPath(Folder), "*.asset").Select(Path.GetFileNameWithoutExtension),
                Is.EquivalentTo(Names));

        [Test]
        public void ItMovesHasAColourAndSaysWhereItsConstantsAreFrom([ValueSource(nameof(Names))] string name)
        {
            FluidLiquid liquid = PackageAssets.Liquid(name);
            Assert.That(liquid.name, Is.EqualTo(name));
            Assert.That(liquid.Profile.Shaders, Is.EqualTo(PackageAssets.Shaders));
            Assert.That(liquid.Sources, Does.Contain("kg/m³"));
            Assert.That(Names.Count(n => PackageAssets.Liquid(n).Profile == liquid.Profile), Is.EqualTo(1), "a motion of its own");
            Assert.That(Names.Count(n => PackageAssets.Liquid(n).Water.ColorAtOneMetre == liquid.Water.ColorAtOneMetre), Is.EqualTo(1));
        }

        [Test]
        public void ItsPictureIsSmall([ValueSource(nameof(Names))] string name)
        {
            Texture2D picture = PackageAssets.Picture(PackageAssets.Liquid(name));
            Assert.That(picture != null, "no picture: run Headless/Docs/liquids.sh");
            Assert.That(Mathf.Max(picture.width, picture.height), Is.InRange(64, LargestPicture));
            Assert.That(new FileInfo(Path.GetFullPath(AssetDatabase.GetAssetPath(picture))).Length, Is.LessThan(MostBytes));
        }

        [Test]
        public void ItsMenuEntryLeavesAWorkingSetUpOnTheFloorAndGoesInOneUndo([ValueSource(nameof(Names))] string name)
        {
            GameObject.CreatePrimitive(PrimitiveType.Plane).transform.position = new Vector3(0f, -0.4f, 0f);
            Undo.IncrementCurrentGroup();
            Choose(name);
            FluidSimulation simulation = SceneObjects.All<FluidSimulation>().Single();
            Assert.That(simulation.Liquid, Is.EqualTo(PackageAssets.Liquid(name)));
            Assert.That(simulation.OwnProfile, Is.Null);
            Assert.That(Selection.activeGameObject, Is.EqualTo(simulation.gameObject));
            Assert.That(simulation.transform.root.position.y, Is.EqualTo(-0.4f).Within(1e-5f), "it stands on its root");
            float gap = simulation.transform.position.y - 0.5f * simulation.DomainSize.y + 0.4f;
            Assert.That(gap, Is.EqualTo(SceneObjects.All<FluidTank>().Single().Edge).Within(1e-5f));
            Assert.That(gap, Is.GreaterThan(simulation.Spacing), "the floor is no wall of the liquid's");
            Assert.That(simulation.TryGetComponent(out FluidWhitewater _), Is.EqualTo(simulation.Liquid.Whitewater));
            Assert.That(simulation.Validate().Select(m => m.ToString()), Is.Empty);
            Assert.That(ViewRules.Check(simulation), Is.Null);
            Undo.PerformUndo();
            Assert.That(SceneObjects.All<FluidSimulation>(), Is.Empty);
        }

        // What the entry GameObject > Fluid > Liquid > NAME calls: the second click after GameObject in an empty scene.
        private static void Choose(string name) => typeof(FluidLiquidMenu).GetMethods(BindingFlags.Static | BindingFlags.NonPublic)
            .Single(m => m.GetCustomAttributes(typeof(MenuItem), false).Cast<MenuItem>()
                .Any(e => e.menuItem == "GameObject/Fluid/Liquid/" + name))
            .Invoke(null, new object[] { new MenuCommand(null) });
    }
}
