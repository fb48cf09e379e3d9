using System;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering.Universal;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Copies of the project's pipeline asset with a renderer of their own, and the fields that only its inspector changes.
    /// </summary>
    internal static class AssetFields
    {
        private const string Path = "Assets/Settings/Universal.asset";
        private const string Renderers = "m_RendererDataList";

        /// <summary>A copy that tests may change.</summary>
        public static UniversalRenderPipelineAsset Copy()
        {
            UniversalRenderPipelineAsset project = UniversalRenderPipeline.asset;
            UniversalRenderPipelineAsset copy =
                Object.Instantiate(project != null ? project : TestAssets.Load<UniversalRenderPipelineAsset>(Path));
            Set(copy, Renderers, new ScriptableRendererData[] { Object.Instantiate(RendererOf(copy)) });
            Set(copy, "m_DefaultRendererIndex", 0);
            return copy;
        }

        /// <summary>Destroys an asset with its renderer.</summary>
        public static void Destroy(UniversalRenderPipelineAsset asset)
        {
            UniversalRendererData renderer = RendererOf(asset);
            Object.DestroyImmediate(asset);
            Object.DestroyImmediate(renderer);
        }

        /// <summary>The first renderer.</summary>
        public static UniversalRendererData RendererOf(UniversalRenderPipelineAsset asset) =>
            (UniversalRendererData)((ScriptableRendererData[])Field(Renderers).GetValue(asset))[0];

        public static void Set(UniversalRenderPipelineAsset asset, string field, object value) => Field(field).SetValue(asset, value);

        private static FieldInfo Field(string name)
        {
            FieldInfo field = typeof(UniversalRenderPipelineAsset).GetField(name, BindingFlags.Instance | BindingFlags.NonPublic);
            Assert.That(field, Is.Not.Null, name);
            return field;
        }
    }
}
