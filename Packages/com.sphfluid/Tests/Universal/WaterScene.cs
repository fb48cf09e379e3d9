using System;
using System.Collections;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Water that stands still on a tiled floor under the sky: a red block behind it, a tall grey one at its right that shades it, and a
    /// camera that sees them from in front. The domain is 0.8 m wide, 0.4 m high and 0.8 m deep, with the origin in its middle.
    /// </summary>
    internal sealed class WaterScene : IDisposable
    {
        public const int Width = 160;
        public const int Height = 120;

        private readonly SimulationRig rig = new SimulationRig();
        private readonly Material sky;
        private readonly Material skybox = RenderSettings.skybox;
        private readonly Light sun = RenderSettings.sun;
        private readonly AmbientMode ambientMode = RenderSettings.ambientMode;
        private readonly Color ambientLight = RenderSettings.ambientLight;
        private readonly Material[] materials;
        private RenderTexture target;

        /// <summary>A block of water 0.4 m wide, 0.25 m high and 0.2 m deep.</summary>
        public WaterScene() : this(new Bounds(new Vector3(0f, -0.075f, -0.1f), new Vector3(0.4f, 0.25f, 0.2f)))
        {
        }

        /// <param name="liquid">Boxes of water; one as large as a particle is a drop of spray.</param>
        public WaterScene(params Bounds[] liquid)
        {
            FluidSimulation simulation = rig.Create("Water", liquid: false);
            simulation.DomainSize = new Vector3(0.8f, 0.4f, 0.8f);
            simulation.Paused = true;
            foreach (Bounds box in liquid)
            {
                FluidVolume volume = rig.AddVolume(simulation);
                volume.transform.localPosition = box.center;
                volume.Size = box.size;
            }
            Water = simulation.gameObject.AddComponent<FluidSurfaceRenderer>();
            Water.Water.ColorAtOneMetre = new Color(0.3f, 0.6f, 0.8f);

            Shader scenery = TestAssets.Load<Shader>("Packages/com.sphfluid/Shaders/Rendering/Scenery.shader");
            materials = new[] { new Material(scenery), new Material(scenery), new Material(scenery) };
            materials[0].SetFloat("_TileSize", 0.25f);
            Floor = Block(new Vector3(0f, -0.25f, 1f), new Vector3(6f, 0.1f, 6f), new Color(0.8f, 0.8f, 0.75f), materials[0]);
            Behind = Block(new Vector3(-0.08f, -0.1f, 0.3f), new Vector3(0.16f, 0.2f, 0.16f), new Color(0.9f, 0.1f, 0.05f), materials[1]);
            Beside = Block(new Vector3(0.35f, 0.05f, -0.1f), new Vector3(0.1f, 0.5f, 0.3f), new Color(0.4f, 0.45f, 0.5f), materials[2]);

            sky = new Material(TestAssets.Load<Shader>("Packages/com.sphfluid/Shaders/Rendering/Sky.shader"));
            sky.SetFloat("_CloudCover", 0f);
            RenderSettings.skybox = sky;
            (RenderSettings.ambientMode, RenderSettings.ambientLight) = (AmbientMode.Flat, new Color(0.35f, 0.35f, 0.35f));
            Sun = rig.NewObject("Sun").AddComponent<Light>();
            Sun.type = LightType.Directional;
            Sun.shadows = LightShadows.Soft;
            Sun.transform.rotation = Quaternion.LookRotation(new Vector3(-0.7f, -0.8f, 0.3f));
            RenderSettings.sun = Sun;

            Camera = NewCamera("Camera");
            Camera.transform.position = new Vector3(0.05f, 0.18f, -1.1f);
            Camera.transform.LookAt(new Vector3(0.02f, -0.04f, 0f));
            Camera.fieldOfView = 32f;
            Samples = 1;
        }

        public FluidSurfaceRenderer Water { get; }

        public GameObject Floor { get; }

        public GameObject Behind { get; }

        public GameObject Beside { get; }

        public Light Sun { get; }

        public Camera Camera { get; }

        /// <summary>Samples of a pixel of the camera's target.</summary>
        public int Samples { set => SetTarget(Width, Height, value); }

        /// <summary>Whether blocks, floor and water cast shadows.</summary>
        public bool CastsShadows
        {
            set
            {
                Water.CastShadows = value;
                ShadowCastingMode mode = value ? ShadowCastingMode.On : ShadowCastingMode.Off;
                foreach (GameObject block in new[] { Floor, Behind, Beside }) block.GetComponent<Renderer>().shadowCastingMode = mode;
            }
        }

        /// <summary>What the camera drew in the last frame.</summary>
        public Picture Picture => Picture.Of(target);

        /// <summary>The middle of the water's front, in the viewport.</summary>
        public Rect Front
        {
            get
            {
                Vector3 low = Camera.WorldToViewportPoint(new Vector3(-0.16f, -0.17f, -0.2f));
                Vector3 high = Camera.WorldToViewportPoint(new Vector3(0.16f, 0.02f, -0.2f));
                return Rect.MinMaxRect(low.x, low.y, high.x, high.y);
            }
        }

        /// <summary>A camera that sees the sky behind the scene.</summary>
        public Camera NewCamera(string name)
        {
            Camera camera = rig.NewObject(name).AddComponent<Camera>();
            camera.nearClipPlane = 0.02f;
            camera.farClipPlane = 20f;
            camera.clearFlags = CameraClearFlags.Skybox;
            return camera;
        }

        public GameObject NewObject(string name) => rig.NewObject(name);

        /// <summary>A block of the red block's material.</summary>
        public GameObject NewBlock(Vector3 centre, Vector3 size) => Block(centre, size, materials[1].color, materials[1]);

        /// <summary>Gives the camera a picture of another size.</summary>
        public void SetTarget(int width, int height, int samples = 1)
        {
            RenderTexture before = target;
            target = new RenderTexture(width, height, 24) { antiAliasing = samples };
            Camera.targetTexture = target;
            if (before != null) Object.DestroyImmediate(before);
        }

        /// <summary>Draws: <c>yield return</c> it. What a test did last comes in the middle of a frame, so two are drawn.</summary>
        public static IEnumerator Frames()
        {
            for (int i = 0; i < 2; i++) yield return null;
        }

        public void Dispose()
        {
            Camera.targetTexture = null;
            rig.Dispose();
            foreach (Material material in materials) Object.DestroyImmediate(material);
            (RenderSettings.skybox, RenderSettings.sun) = (skybox, sun);
            (RenderSettings.ambientMode, RenderSettings.ambientLight) = (ambientMode, ambientLight);
            Object.DestroyImmediate(sky);
            Object.DestroyImmediate(target);
        }

        private GameObject Block(Vector3 centre, Vector3 size, Color colour, Material material)
        {
            GameObject holder = rig.NewObject("Block");
            GameObject block = GameObject.CreatePrimitive(PrimitiveType.Cube);
            Object.DestroyImmediate(block.GetComponent<Collider>());
            block.transform.SetParent(holder.transform, false);
            block.transform.position = centre;
            block.transform.localScale = size;
            material.color = colour;
            block.GetComponent<Renderer>().sharedMaterial = material;
            return block;
        }
    }
}
