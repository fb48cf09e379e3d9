using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.Playables;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A playback that is set up in the Editor: what is checked before it is played, and the folder as the field has it.</summary>
    public sealed class FluidPlaybackEditorTests
    {
        private SequenceFiles files;
        private FluidSimulation simulation;
        private FluidPlayback playback;

        [SetUp]
        public void SetUp()
        {
            EditorSceneManager.NewScene(NewSceneSetup.EmptyScene);
            files = new SequenceFiles();
            simulation = new GameObject("Fluid").AddComponent<FluidSimulation>();
            simulation.Profile = TestAssets.Water;
            (simulation.DomainSize, simulation.Spacing) = (Vector3.one, 0.1f);
            playback = simulation.gameObject.AddComponent<FluidPlayback>();
        }

        [TearDown]
        public void TearDown()
        {
            files.Dispose();
            EditorSceneManager.NewScene(NewSceneSetup.EmptyScene);
        }

        [Test]
        public void ASequenceNeedsNoVolume()
        {
            Assert.That(Issues(), Has.Member(FluidIssue.NoLiquid), "without a folder it is simulated");
            Assert.That(playback.Problem?.Issue, Is.EqualTo(FluidIssue.PlaybackInvalid));
            Write(0.1f, 257);
            playback.Folder = files.Folder;
            Assert.That(Issues(), Is.Empty);
            Assert.That(playback.Problem, Is.Null);
            playback.enabled = false;
            Assert.That(Issues(), Has.Member(FluidIssue.NoLiquid));
        }

        [Test]
        public void WhatDiffersIsSaidBeforePlay()
        {
            Write(0.2f, 3);
            playback.Folder = files.Folder;
            Assert.That(Issues(), Is.EqualTo(new[] { FluidIssue.PlaybackDiffers }));
            simulation.Spacing = 0.2f;
            Assert.That(Issues(), Is.Empty);
        }

        [Test]
        public void MoreParticlesThanTheProfileAllowsAreNamed()
        {
            Write(0.1f, 257);
            playback.Folder = files.Folder;
            FluidProfile small = Object.Instantiate(simulation.Profile);
            try
            {
                small.MaxParticles = 256;
                simulation.Profile = small;
                FluidMessage message = simulation.Validate().Single();
                Assert.That(message.Issue, Is.EqualTo(FluidIssue.TooManyParticles));
                Assert.That(message.Text, Does.StartWith("A frame of the playback has 257 particles, but the profile"));
            }
            finally
            {
                Object.DestroyImmediate(small);
            }
        }

        [Test]
        public void AnyMethodMayBeSet([Values(FluidMethodKind.Thesis, FluidMethodKind.Robust,
            FluidMethodKind.Automatic)] FluidMethodKind method)
        {
            Write(0.1f, 3);
            playback.Folder = files.Folder;
            simulation.Method = method;
            Assert.That(Issues(), Is.Empty);
        }

        [Test]
        public void AClipKnowsTheLengthAndChangesNothing()
        {
            Write(0.1f, 3);
            playback.Folder = files.Folder;
            FluidPlaybackClip clip = ScriptableObject.CreateInstance<FluidPlaybackClip>();
            PlayableGraph graph = PlayableGraph.Create("Preview");
            try
            {
                clip.CreatePlayable(graph, null);
                Assert.That(clip.duration, Is.EqualTo(5.0), "a clip is without a playback when it is made, which nobody needs to hear of");
                clip.Playback = new ExposedReference<FluidPlayback> { defaultValue = playback };
                Playable playable = clip.CreatePlayable(graph, null);
                Assert.That(clip.duration, Is.EqualTo(1.0));
                ScriptPlayableOutput.Create(graph, "Track").SetSourcePlayable(playable);
                playable.SetTime(0.5);
                graph.Evaluate();
                Assert.That((playback.Time, playback.Clock), Is.EqualTo((0f, FluidPlaybackClock.SceneTime)),
                    "the scene would be changed by looking at it");
            }
            finally
            {
                graph.Destroy();
                Object.DestroyImmediate(clip);
            }
            LogAssert.NoUnexpectedReceived();
        }

        [TestCase("/project/Assets/StreamingAssets/Floods/A", "Floods/A")]
        [TestCase("/project/Assets/StreamingAssetsOfOthers/A", "/project/Assets/StreamingAssetsOfOthers/A")]
        [TestCase("/data/A", "/data/A")]
        public void AFolderInStreamingAssetsIsFoundFromThere(string chosen, string expected)
        {
            string root = Path.GetFullPath("/").Replace('\\', '/').TrimEnd('/');
            string shortened = FluidPlaybackEditor.Shortened(chosen, "/project/Assets/StreamingAssets");
            Assert.That(shortened, Is.EqualTo(expected.StartsWith("/", System.StringComparison.Ordinal) ? root + expected : expected));
        }

        private void Write(float spacing, int count) =>
            files.Write(new[] { 0.0, 1.0 }, i => ParticleSets.Random(count, Vector3.one, 1f, i), Vector3.one, spacing);

        private FluidIssue[] Issues() => simulation.Validate().Select(m => m.Issue).ToArray();
    }
}
