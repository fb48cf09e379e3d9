using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// What a liquid mirrors: the smallest of the most important reflection probes around it, else the scene's own reflection, which is the
    /// sky. Read from the scene rather than from a pipeline's shader variables, as <see cref="SceneLighting"/> reads the light.
    /// </summary>
    internal sealed class SceneReflection
    {
        // Frames between two searches for a probe.
        private const int SearchInterval = 30;

        // Of Unity's reflection maps, which are blurred from sharp (level 0) to rough (6).
        private const float RoughestLevel = 6f;

        private ReflectionProbe probe;
        private int searchedAt = int.MinValue;

        /// <summary>Sets the map and how to read it; without one, shaders take the ambient light.</summary>
        /// <param name="properties">Where it is set.</param>
        /// <param name="bounds">Where the liquid is; a probe must hold its middle.</param>
        /// <param name="smoothness">Smoothness of the surface, 0 to 1.</param>
        public void Apply(MaterialPropertyBlock properties, Bounds bounds, float smoothness)
        {
            ReflectionProbe found = ProbeAround(bounds.center);
            Texture map = found != null ? found.texture : ReflectionProbe.defaultTexture;
            bool usable = map != null && map.dimension == TextureDimension.Cube && DrawPipeline.Active != DrawPipelineKind.HighDefinition;
            // Of the sky, Unity 6 bakes the map with the scene's light: black where that was not done. A black map of the user's is meant.
            bool baked = found == null && RenderSettings.defaultReflectionMode == DefaultReflectionMode.Skybox;
            properties.SetVector(RenderShaderIds.FluidReflection, new Vector4(usable ? 1f : 0f, Level(smoothness), baked ? 1f : 0f, 0f));
            if (!usable) return;
            properties.SetTexture(RenderShaderIds.FluidReflectionMap, map);
            properties.SetVector(RenderShaderIds.FluidReflectionDecode,
                found != null ? found.textureHDRDecodeValues : ReflectionProbe.defaultTextureHDRDecodeValues);
        }

        // Unity's step from perceptual roughness r to a level: 6 r (1.7 - 0.7 r), e.g. 0.98 for r = 0.1.
        private static float Level(float smoothness)
        {
            float roughness = 1f - Mathf.Clamp01(smoothness);
            return RoughestLevel * roughness * (1.7f - 0.7f * roughness);
        }

        private ReflectionProbe ProbeAround(Vector3 point)
        {
            int frame = Time.frameCount;
            if (frame < searchedAt || frame - (long)searchedAt >= SearchInterval || (probe != null && !Holds(probe, point)))
            {
                probe = Find(point);
                searchedAt = frame;
            }
            return probe != null ? probe : null;
        }

        private static ReflectionProbe Find(Vector3 point)
        {
            ReflectionProbe best = null;
            foreach (ReflectionProbe candidate in SceneObjects.All<ReflectionProbe>())
            {
                if (Holds(candidate, point) && (best == null || IsBetter(candidate, best))) best = candidate;
            }
            return best;
        }

        private static bool Holds(ReflectionProbe candidate, Vector3 point) =>
            candidate.isActiveAndEnabled && candidate.texture != null && candidate.bounds.Contains(point);

        private static bool IsBetter(ReflectionProbe a, ReflectionProbe b)
        {
            if (a.importance != b.importance) return a.importance > b.importance;
            int bySize = a.bounds.size.sqrMagnitude.CompareTo(b.bounds.size.sqrMagnitude);
            return bySize < 0 || (bySize == 0 && HierarchyOrder.Compare(a, b) < 0);
        }
    }
}
