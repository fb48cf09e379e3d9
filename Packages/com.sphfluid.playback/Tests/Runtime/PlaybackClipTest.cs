using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Playables;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>A graph of playables, as a Timeline makes one, for clips of a played liquid.</summary>
    public abstract class PlaybackClipTest : PlaybackTest
    {
        private readonly List<Object> made = new List<Object>();

        protected PlayableGraph graph;
        private protected Table table;

        [SetUp]
        public void MakeGraph()
        {
            graph = PlayableGraph.Create("Timeline");
            graph.SetTimeUpdateMode(DirectorUpdateMode.Manual);
            table = rig.NewObject("Director").AddComponent<Table>();
            graph.SetResolver(table);
        }

        [TearDown]
        public void DestroyGraph()
        {
            if (graph.IsValid()) graph.Destroy();
            foreach (Object clip in made) Object.DestroyImmediate(clip);
            made.Clear();
        }

        protected FluidPlaybackClip Clip(float start = 0f, float speed = 1f)
        {
            FluidPlaybackClip clip = ScriptableObject.CreateInstance<FluidPlaybackClip>();
            made.Add(clip);
            clip.name = "Wave";
            (clip.Start, clip.Speed) = (start, speed);
            clip.Playback = new ExposedReference<FluidPlayback> { exposedName = "Playback" };
            table.SetReferenceValue("Playback", playback);
            return clip;
        }

        // On an output of its own.
        protected Playable Add(FluidPlaybackClip clip)
        {
            Playable playable = clip.CreatePlayable(graph, table.gameObject);
            Show(playable);
            return playable;
        }

        protected void Show<T>(T playable)
            where T : struct, IPlayable => ScriptPlayableOutput.Create(graph, "Track").SetSourcePlayable(playable);

        protected void ShowAt<T>(T playable, double time) where T : struct, IPlayable
        {
            playable.SetTime(time);
            graph.Evaluate();
        }

        // What a scene's references are to a Timeline.
        private protected sealed class Table : MonoBehaviour, IExposedPropertyTable
        {
            private readonly Dictionary<PropertyName, Object> values = new Dictionary<PropertyName, Object>();

            public void SetReferenceValue(PropertyName id, Object value) => values[id] = value;

            public Object GetReferenceValue(PropertyName id, out bool idValid)
            {
                idValid = values.TryGetValue(id, out Object value);
                return value;
            }

            public void ClearReferenceValue(PropertyName id) => values.Remove(id);
        }
    }
}
