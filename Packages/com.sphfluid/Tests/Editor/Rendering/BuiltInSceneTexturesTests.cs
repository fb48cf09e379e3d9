using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What is kept of cameras that water was drawn for.</summary>
    public sealed class BuiltInSceneTexturesTests
    {
        [Test]
        public void DestroyedCamerasAreForgotten()
        {
            var textures = new BuiltInSceneTextures();
            Camera lasting = NewCamera();
            try
            {
                textures.Request(lasting);
                for (int i = 0; i < 10; i++)
                {
                    Camera brief = NewCamera();
                    textures.Request(brief);
                    Assert.That(textures.Count, Is.EqualTo(2));
                    Object.DestroyImmediate(brief.gameObject);
                }
                textures.Release();
                Assert.That(textures.Count, Is.Zero);
                Assert.That(lasting.forceIntoRenderTexture, Is.False);
            }
            finally
            {
                textures.Release();
                Object.DestroyImmediate(lasting.gameObject);
            }
        }

        private static Camera NewCamera() => new GameObject("Camera").AddComponent<Camera>();
    }
}
