using System;
using System.Collections.Generic;
using System.IO;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>
    /// Saves the relaxed start of a simulation beside its scene, so that it starts at rest at once. Run it for scenes by -executeMethod
    /// SphFluid.Editor.RelaxedStartAsset.SaveScenes, with --scenes and their paths.
    /// </summary>
    public static class RelaxedStartAsset
    {
        /// <summary>Saves those of the simulations of scenes that have one; ends with exit code 1 where one cannot be saved.</summary>
        public static void SaveScenes()
        {
            string[] words = Environment.GetCommandLineArgs();
            bool isGood = true;
            for (int i = Array.IndexOf(words, "--scenes") + 1; i > 0 && i < words.Length; i++)
            {
                EditorSceneManager.OpenScene(words[i]);
                foreach (FluidSimulation simulation in SceneObjects.All<FluidSimulation>())
                    if (simulation.StartRelaxation != FluidStartRelaxation.None) isGood &= TrySave(simulation);
            }
            EditorApplication.Exit(isGood ? 0 : 1);
        }

        /// <summary>Brings a simulation's liquid to rest, saves where it is then, and has the simulation start from that.</summary>
        /// <param name="simulation">A simulation in a scene that was saved.</param>
        /// <returns>False where it cannot start, or the relaxation was ended; the console says why.</returns>
        internal static bool TrySave(FluidSimulation simulation)
        {
            string scene = simulation.gameObject.scene.path;
            if (string.IsNullOrEmpty(scene))
            {
                Debug.LogError($"'{simulation.name}': Save the scene first; its relaxed start is saved beside it.", simulation);
                return false;
            }
            var said = new List<FluidMessage>();
            byte[] bytes = Bytes(simulation, said);
            foreach (FluidMessage message in said) message.Log();
            if (bytes == null) return false;
            string path = $"{Path.GetDirectoryName(scene)}/{Path.GetFileNameWithoutExtension(scene)} {simulation.name} at Rest.bytes";
            File.WriteAllBytes(path, bytes);
            AssetDatabase.ImportAsset(path);
            Undo.RecordObject(simulation, "Save Relaxed Start");
            simulation.SavedStart = AssetDatabase.LoadAssetAtPath<TextAsset>(path);
            EditorSceneManager.MarkSceneDirty(simulation.gameObject.scene);
            return true;
        }

        private static byte[] Bytes(FluidSimulation simulation, List<FluidMessage> said)
        {
            using (var collision = new CollisionScene())
            {
                FluidSpec spec = simulation.Spec;
                spec.SavedStart = null;
                if (spec.StartRelaxation == FluidStartRelaxation.Saved) spec.StartRelaxation = FluidStartRelaxation.Hydrostatic;
                said.AddRange(FluidChecks.Check(spec, FluidScene.Volumes(simulation), collision, FluidSpawner.Fill, out FluidStart start));
                if (start == null) return null;
                try
                {
                    spec = start.Resolve(spec);
                    return new SavedStart(RelaxedStart.Settings(spec, start), start.Particles, collision.Solids)
                        .Write(RelaxedStart.Particles(spec, start, collision, simulation.Watch, said.Add));
                }
                catch (OperationCanceledException)
                {
                    return null;
                }
                catch (Exception exception) when (exception is ArgumentException || exception is FluidDeviceException)
                {
                    said.Add(FluidReports.Failure(simulation, exception));
                    return null;
                }
            }
        }
    }
}
