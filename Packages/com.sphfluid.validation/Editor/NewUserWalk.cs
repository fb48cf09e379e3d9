using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using SphFluid.Editor;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace SphFluid.Validation.Editor
{
    /// <summary>
    /// A new user's first minutes, by the code that the menus call: an empty scene, a floor, GameObject > Fluid > Tank, Emitter, and in
    /// scenes of their own Surface and Particles. After each step the scene is saved, to be played. Run it by -executeMethod
    /// SphFluid.Validation.Editor.NewUserWalk.Write, with --folder PATH below the project (Assets/NewUser).
    /// </summary>
    public static class NewUserWalk
    {
        private const string DefaultFolder = "Assets/NewUser", FloorMaterial = "Assets/Materials/Ground.mat";

        /// <summary>Writes the scenes; ends with exit code 1 where one cannot be saved, or its set-up has a message.</summary>
        public static void Write()
        {
            string[] words = Environment.GetCommandLineArgs();
            int at = Array.IndexOf(words, "--folder");
            string folder = at >= 0 && at + 1 < words.Length ? words[at + 1] : DefaultFolder;
            Directory.CreateDirectory(folder);

            bool isGood = Step(folder, "1-floor", Begin);
            isGood &= Step(folder, "2-tank", () => FluidMenu.CreateTank(new MenuCommand(null)));
            isGood &= Step(folder, "3-emitter", () => FluidMenu.CreateEmitter(new MenuCommand(Liquids()[0].gameObject)));
            Begin();
            isGood &= Step(folder, "4-surface", () => FluidMenu.CreateWithSurface(new MenuCommand(null)));
            Begin();
            isGood &= Step(folder, "5-particles", () => FluidMenu.CreateWithParticles(new MenuCommand(null)));
            EditorApplication.Exit(isGood ? 0 : 1);
        }

        // A scene as the Editor makes it, with a floor, seen from where Align With View would put the camera.
        private static void Begin()
        {
            EditorSceneManager.NewScene(NewSceneSetup.DefaultGameObjects);
            Camera.main.transform.position = new Vector3(1.1f, 1.25f, -1.9f);
            Camera.main.transform.LookAt(new Vector3(0f, 0.5f, 0f));
            GameObject floor = GameObject.CreatePrimitive(PrimitiveType.Plane);
            var material = AssetDatabase.LoadAssetAtPath<Material>(FloorMaterial); // the player has no shader Lit
            if (material != null) floor.GetComponent<MeshRenderer>().sharedMaterial = material;
        }

        private static bool Step(string folder, string name, Action menu)
        {
            menu();
            int messages = 0;
            foreach (FluidSimulation simulation in Liquids())
            {
                foreach (FluidMessage message in simulation.Validate())
                {
                    Console.Error.WriteLine(message.ToString());
                    messages++;
                }
            }
            string path = $"{folder}/{name}.unity";
            bool saved = EditorSceneManager.SaveScene(SceneManager.GetActiveScene(), path);
            Console.WriteLine(saved ? $"wrote {path}" : $"could not write {path}");
            return saved && messages == 0;
        }

        private static IReadOnlyList<FluidSimulation> Liquids() => LoadedScenes.Find<FluidSimulation>().ToList();
    }
}
