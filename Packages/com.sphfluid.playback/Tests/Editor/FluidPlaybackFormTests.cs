using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace SphFluid.Tests
{
    /// <summary>What the package shows in the Editor: help, icons, inspector and menu.</summary>
    public sealed class FluidPlaybackFormTests
    {
        private static readonly Type[] Documented = { typeof(FluidPlayback), typeof(FluidPlaybackClip) };

        [Test]
        public void TheHelpIsAHeadingOfAPageThatExists([ValueSource(nameof(Documented))] Type type)
        {
            var page = (ManualPageAttribute)Attribute.GetCustomAttribute(type, typeof(HelpURLAttribute));
            string file = FluidManual.FolderOf("com.sphfluid.playback") + page.Page + ".md";
            Assert.That(page.URL, Is.EqualTo(new Uri(Path.GetFullPath(file)).AbsoluteUri));
            if (page.Heading.Length > 0) Assert.That(ManualHeadings.Of(file), Has.Member(page.Heading));
        }

        [Test]
        public void TheScriptHasAnIcon([ValueSource(nameof(Documented))] Type type)
        {
            string meta = File.ReadAllText(Path.GetFullPath($"Packages/com.sphfluid.playback/Runtime/{type.Name}.cs.meta"));
            string guid = Regex.Match(meta, "icon: {fileID: 2800000, guid: ([0-9a-f]{32}), type: 3}").Groups[1].Value;
            Assert.That(AssetDatabase.GUIDToAssetPath(guid), Is.EqualTo($"Packages/com.sphfluid.playback/Editor/Icons/{type.Name}.png"));
        }

        [Test]
        public void TheInspectorAllowsSeveralObjects() =>
            Assert.That(typeof(FluidPlaybackEditor).IsDefined(typeof(CanEditMultipleObjects), false));

        [Test]
        public void TheMenuMakesAPlaybackInOneStepOfUndo()
        {
            EditorSceneManager.NewScene(NewSceneSetup.EmptyScene);
            FluidPlaybackMenu.CreatePlayback(new MenuCommand(null));
            GameObject made = SceneManager.GetActiveScene().GetRootGameObjects().Single();
            Assert.That(made.GetComponents<MonoBehaviour>().Select(c => c.GetType()),
                Is.EquivalentTo(new[] { typeof(FluidSimulation), typeof(FluidSurfaceRenderer), typeof(FluidPlayback) }));
            Undo.PerformUndo();
            Assert.That(SceneManager.GetActiveScene().GetRootGameObjects(), Is.Empty);
        }
    }
}
