using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The scene's main light and ambient light for a draw. Read from the scene rather than from a pipeline's shader variables, whose names
    /// differ: the drawings look alike in every render pipeline.
    /// </summary>
    internal sealed class SceneLighting
    {
        // Frames between two searches for a brighter light; one that was switched off is noticed at once.
        private const int SearchInterval = 30;

        private readonly Vector4[] ambient = new Vector4[7];
        private Light brightest;
        private int searchedAt = int.MinValue;

        /// <summary>Sets direction and colour of the main light and the ambient light.</summary>
        public void Apply(MaterialPropertyBlock properties)
        {
            Light light = MainLight();
            properties.SetVector(RenderShaderIds.FluidLightDirection, light != null ? -light.transform.forward : Vector3.up);
            properties.SetVector(RenderShaderIds.FluidLightColour, light != null ? ColourOf(light) : Vector4.zero);
            Pack(Lit(RenderSettings.ambientProbe), ambient);
            properties.SetVectorArray(RenderShaderIds.FluidAmbient, ambient);
        }

        /// <summary>
        /// Colour times intensity as the pipelines hand it to shaders: in linear colour space linear, and the intensity with it or apart
        /// from it as <see cref="GraphicsSettings.lightsUseLinearIntensity"/> says. E.g. white of intensity 0.5 is 0.5 or, multiplied
        /// before, 0.214.
        /// </summary>
        public static Vector4 ColourOf(Light light)
        {
            Color colour = light.color;
            Color filter = Color.white;
            if (GraphicsSettings.lightsUseColorTemperature && light.useColorTemperature)
            {
                filter = Mathf.CorrelatedColorTemperatureToRGB(light.colorTemperature);
            }
            if (QualitySettings.activeColorSpace != ColorSpace.Linear) return colour * filter.gamma * light.intensity;
            if (GraphicsSettings.lightsUseLinearIntensity) return colour.linear * filter * light.intensity;
            return (colour * light.intensity).linear * filter;
        }

        /// <summary>
        /// Spherical harmonics in the order that shaders evaluate them, as Unity packs unity_SHAr ... unity_SHC: for each colour four
        /// linear coefficients, for each colour four quadratic ones, and the last of all three.
        /// </summary>
        public static void Pack(SphericalHarmonicsL2 probe, Vector4[] packed)
        {
            for (int c = 0; c < 3; c++)
            {
                packed[c] = new Vector4(probe[c, 3], probe[c, 1], probe[c, 2], probe[c, 0] - probe[c, 6]);
                packed[3 + c] = new Vector4(probe[c, 4], probe[c, 5], 3f * probe[c, 6], probe[c, 7]);
            }
            packed[6] = new Vector4(probe[0, 8], probe[1, 8], probe[2, 8], 1f);
        }

        /// <summary>
        /// The scene's ambient light; where it is the sky's and was never baked, which leaves it black in Unity 6, that of the three
        /// colours in the lighting settings.
        /// </summary>
        internal static SphericalHarmonicsL2 Lit(SphericalHarmonicsL2 probe)
        {
            bool meantToShine = RenderSettings.ambientMode == AmbientMode.Skybox && RenderSettings.ambientIntensity > 0f;
            return meantToShine && probe == default ? Gradient() : probe;
        }

        // From the ground's colour below to the sky's above, through the mean of both and the equator's.
        private static SphericalHarmonicsL2 Gradient()
        {
            Color sky = RenderSettings.ambientSkyColor.linear, ground = RenderSettings.ambientGroundColor.linear;
            Color middle = 0.25f * (sky + ground) + 0.5f * RenderSettings.ambientEquatorColor.linear;
            var probe = new SphericalHarmonicsL2();
            for (int c = 0; c < 3; c++)
            {
                probe[c, 0] = middle[c];
                probe[c, 1] = 0.5f * (sky[c] - ground[c]);
            }
            return probe;
        }

        // The lighting settings' sun, else the brightest directional light, as Unity chooses its main light. Only the search allocates:
        // scenes whose Sun Source is assigned never do.
        internal Light MainLight()
        {
            Light sun = RenderSettings.sun;
            if (IsUsable(sun)) return sun;
            int frame = Time.frameCount;
            if (!IsUsable(brightest) || frame < searchedAt || frame - (long)searchedAt >= SearchInterval)
            {
                brightest = FindBrightest();
                searchedAt = frame;
            }
            return brightest;
        }

        private static Light FindBrightest()
        {
            Light found = null;
            float most = 0f;
            foreach (Light light in SceneObjects.All<Light>())
            {
                float brightness = light.intensity * light.color.maxColorComponent;
                if (!IsUsable(light) || brightness < most ||
                    (brightness == most && found != null && HierarchyOrder.Compare(light, found) > 0))
                {
                    continue;
                }
                found = light;
                most = brightness;
            }
            return found;
        }

        private static bool IsUsable(Light light) => light != null && light.isActiveAndEnabled && light.type == LightType.Directional;
    }
}
