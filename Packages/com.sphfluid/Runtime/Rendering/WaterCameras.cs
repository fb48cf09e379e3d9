using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Prepares each camera for the water that it is about to draw: the scene's textures are asked for, and every liquid's thickness is
    /// drawn as the camera sees it. Listens to cameras only while there is water.
    /// </summary>
    internal static class WaterCameras
    {
        private static readonly List<ThicknessPass> passes = new List<ThicknessPass>();
        private static readonly List<IBehindWater> behind = new List<IBehindWater>();
        private static readonly BuiltInSceneTextures builtIn = new BuiltInSceneTextures();
        private static Camera[] found = new Camera[4];
        private static CommandBuffer cmd;
        private static Vector2Int largestView;

        /// <summary>The Universal Render Pipeline's textures, where the package's assembly for it is compiled; else null.</summary>
        internal static ISceneTextureSource Universal { get; set; }

        /// <summary>Whether any water is drawn, so that cameras are listened to.</summary>
        public static bool IsListening => passes.Count > 0;

        /// <summary>Pixels of the largest camera's picture so far, at least one.</summary>
        public static Vector2Int LargestView
        {
            get
            {
                int count = FindCameras();
                for (int i = 0; i < count; i++) Widen(found[i]);
                return Vector2Int.Max(largestView, Vector2Int.one);
            }
        }

        /// <summary>
        /// Whether a camera may be in the liquid: an enabled one now, or one that drew it in the last frame, such as the Editor's.
        /// </summary>
        public static bool AnyIsNear(ThicknessPass pass)
        {
            int count = FindCameras();
            for (int i = 0; i < count; i++)
            {
                if (pass.IsNear(found[i])) return true;
            }
            return pass.NearAt >= Time.frameCount - 1;
        }

        public static void Add(ThicknessPass pass, SprayDrawing spray)
        {
            if (passes.Count == 0) Listen();
            passes.Add(pass);
            behind.Add(spray);
        }

        public static void Remove(ThicknessPass pass, SprayDrawing spray)
        {
            behind.Remove(spray);
            if (passes.Remove(pass) && passes.Count == 0) StopListening();
        }

        /// <summary>Adds what is seen through water, whether there is water or not.</summary>
        public static void Add(IBehindWater drawing) => behind.Add(drawing);

        public static void Remove(IBehindWater drawing) => behind.Remove(drawing);

        /// <summary>Whether a camera sees something of this frame through water.</summary>
        public static bool SeesBehind(Camera camera)
        {
            foreach (IBehindWater drawing in behind)
            {
                if (drawing.IsSeenBy(camera)) return true;
            }
            return false;
        }

        /// <summary>Records what a camera sees through water into the picture of the scene, which is the render target.</summary>
        /// <param name="cmd">Where it is recorded.</param>
        /// <param name="camera">The camera, whose matrices are set.</param>
        /// <param name="height">Pixels of the picture's height.</param>
        public static void RecordBehind(CommandBuffer cmd, Camera camera, int height)
        {
            cmd.SetGlobalFloat(RenderShaderIds.FluidSceneHeight, height);
            foreach (IBehindWater drawing in behind)
            {
                if (!drawing.IsSeenBy(camera)) continue;
                drawing.RecordBehindWater(cmd, 0);
                if (EyeDraws.TryGetPicture(camera, out _)) drawing.RecordBehindWater(cmd, 1);
            }
        }

        /// <summary>
        /// The thickness of the water that fills the domain of a drawing; null where no such water is drawn in this frame.
        /// </summary>
        public static ThicknessPass ThicknessOf(in DrawPlacement placement)
        {
            foreach (ThicknessPass pass in passes)
            {
                if (pass.IsOf(placement)) return pass;
            }
            return null;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void ResetStatics()
        {
            while (IsListening) Remove(passes[0], null);
            behind.Clear();
        }

        private static void Listen()
        {
            cmd = new CommandBuffer { name = "Fluid Water" };
            Camera.onPreCull += PrepareBuiltIn;
            Camera.onPreRender += PrepareEye;
            RenderPipelineManager.beginCameraRendering += PrepareScriptable;
        }

        private static void StopListening()
        {
            Camera.onPreCull -= PrepareBuiltIn;
            Camera.onPreRender -= PrepareEye;
            RenderPipelineManager.beginCameraRendering -= PrepareScriptable;
            builtIn.Release();
            Universal?.Release();
            cmd.Dispose();
            cmd = null;
            largestView = Vector2Int.zero;
            System.Array.Clear(found, 0, found.Length);
        }

        private static int FindCameras()
        {
            if (found.Length < Camera.allCamerasCount) found = new Camera[Camera.allCamerasCount];
            return Camera.GetAllCameras(found);
        }

        private static void PrepareBuiltIn(Camera camera)
        {
            if (!Record(camera, builtIn)) return;
            builtIn.RecordCopy(camera);
            Graphics.ExecuteCommandBuffer(cmd);
        }

        // Multi-pass stereo: the eyes are culled once and drawn one after the other.
        private static void PrepareEye(Camera camera)
        {
            if (!camera.stereoEnabled || EyeDraws.TryGetPicture(camera, out _)) return;
            cmd.Clear();
            RecordThickness(cmd, camera, CameraViews.Of(camera));
            Graphics.ExecuteCommandBuffer(cmd);
        }

        private static void PrepareScriptable(ScriptableRenderContext context, Camera camera)
        {
            bool universal = DrawPipeline.Active == DrawPipelineKind.Universal;
            if (!Record(camera, universal ? Universal : null)) return;
            context.ExecuteCommandBuffer(cmd);
        }

        private static bool Record(Camera camera, ISceneTextureSource source)
        {
            if (camera.cameraType == CameraType.Preview) return false;
            LiquidViews.Prepare(camera);
            Widen(camera);
            var size = new Vector2Int(camera.pixelWidth, camera.pixelHeight);
            SceneTextures scene = source != null ? source.Request(camera) : default;
            cmd.Clear();
            cmd.SetGlobalVector(RenderShaderIds.FluidScene, scene.ToVector());
            cmd.SetGlobalVector(RenderShaderIds.FluidThicknessView, new Vector4(size.x, size.y, 0f, 0f));
            RecordThickness(cmd, camera, CameraViews.Of(camera));
            if (scene.Depth) WaterCaustics.RecordMaps(cmd, camera);
            return true;
        }

        /// <summary>Records every liquid's thickness as a camera sees it; leaves another render target and other matrices.</summary>
        public static void RecordThickness(CommandBuffer cmd, Camera camera, in CameraViews views)
        {
            var size = new Vector2Int(camera.pixelWidth, camera.pixelHeight);
            foreach (ThicknessPass pass in passes)
            {
                if (!pass.IsSeenBy(camera)) continue;
                if (pass.IsNear(camera)) pass.NearAt = Time.frameCount;
                pass.Record(cmd, views, size);
            }
        }

        private static void Widen(Camera camera) =>
            largestView = Vector2Int.Max(largestView, new Vector2Int(camera.pixelWidth, camera.pixelHeight));
    }
}
