using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>A texture set by name, and which part of it.</summary>
internal readonly record struct TextureSlot(Texture? Texture, int MipLevel = 0, RenderTextureSubElement Element = RenderTextureSubElement.Default);
