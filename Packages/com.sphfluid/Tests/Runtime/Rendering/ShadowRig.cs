using System;
using System.Collections;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Liquid of known shape around the origin, a camera that looks down on a square metre of it, a light and a box above it that casts a
    /// shadow. There is no other light.
    /// </summary>
    internal sealed class ShadowRig : IDisposable
    {
        public const int Size = 64;
        public const float Spacing = 0.02f;

        private readonly FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
        private readonly AmbientMode ambientMode = RenderSettings.ambientMode;
        private readonly Color ambientLight = RenderSettings.ambientLight;
        private readonly Light sun = RenderSettings.sun;
        private readonly FluidWaterLook waterLook = new FluidWaterLook { ColorAtOneMetre = new Color(0.2f, 0.5f, 0.7f), Visibility = 1f };
        private readonly SurfaceDrawing drawing;
        private UploadedSurface surface;

        public ShadowRig(FluidSurfaceLook look)
        {
            drawing = look == FluidSurfaceLook.Water ? (SurfaceDrawing)new WaterDrawing(shaders) : new OpaqueDrawing(shaders);
            Surface = new UploadedSurface().Box(new Vector3(0f, -0.2f, 0f), new Vector3(1.2f, 0.4f, 1.2f));
            (RenderSettings.ambientMode, RenderSettings.ambientLight) = (AmbientMode.Flat, Color.black);
            Camera = NewCamera(Size);
            Light = NewLight(new Vector3(0.5f, 1f, 0.2f));
            RenderSettings.sun = Light;
            Occluder = GameObject.CreatePrimitive(PrimitiveType.Cube);
            Occluder.transform.localScale = new Vector3(1f, 0.1f, 3f);
            Occluder.transform.position = new Vector3(-0.2f, 0.6f, 0f);
            Occluder.GetComponent<Renderer>().shadowCastingMode = ShadowCastingMode.ShadowsOnly;
            MainLightShadows.Add(Camera, shaders);
        }

        public Camera Camera { get; }

        public Light Light { get; set; }

        /// <summary>Casts a shadow, and is not seen itself.</summary>
        public GameObject Occluder { get; }

        public bool CastShadows { get; set; }

        public bool ReceiveShadows { get; set; } = true;

        /// <summary>Light that the water's own shadow takes away.</summary>
        public float OwnShadow { set => waterLook.Shadow = value; }

        public UploadedSurface Surface
        {
            set
            {
                surface?.Dispose();
                surface = value;
            }
        }

        public static Camera NewCamera(int size)
        {
            var camera = new GameObject("Camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(0f, 2f, 0f);
            camera.transform.rotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            camera.orthographic = true;
            camera.orthographicSize = 0.5f;
            camera.nearClipPlane = 0.1f;
            camera.farClipPlane = 10f;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.black;
            camera.allowMSAA = false;
            camera.targetTexture = new RenderTexture(size, size, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear);
            return camera;
        }

        public static Light NewLight(Vector3 towards)
        {
            var light = new GameObject("Light").AddComponent<Light>();
            light.type = LightType.Directional;
            light.shadows = LightShadows.Soft;
            light.transform.rotation = Quaternion.LookRotation(-towards);
            return light;
        }

        /// <summary>
        /// Where the edge of the box's shadow lies on the plane y = 0, of its side towards +x and of a light from there [m].
        /// </summary>
        public float EdgeOfShadow
        {
            get
            {
                Vector3 towards = -Light.transform.forward;
                Bounds box = Occluder.GetComponent<Renderer>().bounds;
                return box.max.x - box.min.y * towards.x / towards.y;
            }
        }

        /// <summary>
        /// Draws: <c>yield return</c> it, then read <see cref="Pixels(Camera)"/>. What a test does first comes before any frame, so two are
        /// drawn.
        /// </summary>
        public IEnumerator Frame()
        {
            for (int i = 0; i < 2; i++)
            {
                Draw();
                yield return null;
            }
        }

        private void Draw()
        {
            var placement = new DrawPlacement(Matrix4x4.identity, Vector3.one * 4f, 0f, 0, CastShadows, ReceiveShadows, Spacing);
            SurfaceBuffers buffers = surface.Buffers;
            drawing.Fill(buffers, new SurfaceGrid(Vector3.one * -2f, Vector3.one * 4f, 64), SurfaceWalls.Closed, placement);
            if (drawing is WaterDrawing water)
            {
                water.SetLook(buffers, waterLook, WaterCameras.LargestView, placement);
                water.SetSurface(waterLook);
            }
            else
            {
                ((OpaqueDrawing)drawing).SetLook(new Color(0.5f, 0.6f, 0.7f), 0.5f);
            }
            drawing.Draw(buffers, null, placement);
        }

        /// <summary>What the camera saw, green, row 0 the lowest.</summary>
        public static float[] Pixels(Camera camera)
        {
            RenderTexture before = RenderTexture.active;
            RenderTexture target = camera.targetTexture;
            var picture = new Texture2D(target.width, target.height, TextureFormat.RGBAFloat, false, true);
            RenderTexture.active = target;
            picture.ReadPixels(new Rect(0, 0, target.width, target.height), 0, 0);
            picture.Apply();
            RenderTexture.active = before;
            float[] pixels = Array.ConvertAll(picture.GetPixels(), p => p.g);
            Object.DestroyImmediate(picture);
            return pixels;
        }

        public float[] Pixels() => Pixels(Camera);

        /// <summary>Of the middle of a pixel, along x or z [m].</summary>
        public static float Place(int pixel, int size = Size) => (pixel + 0.5f) / size - 0.5f;

        public static void Destroy(Camera camera)
        {
            RenderTexture target = camera.targetTexture;
            camera.targetTexture = null;
            Object.DestroyImmediate(camera.gameObject);
            Object.DestroyImmediate(target);
        }

        public void Dispose()
        {
            MainLightShadows.Remove(Camera);
            drawing.Dispose();
            surface?.Dispose();
            Destroy(Camera);
            Object.DestroyImmediate(Occluder);
            if (Light != null) Object.DestroyImmediate(Light.gameObject);
            (RenderSettings.ambientMode, RenderSettings.ambientLight, RenderSettings.sun) = (ambientMode, ambientLight, sun);
        }
    }
}
