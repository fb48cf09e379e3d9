using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Shader
{
    private static PropertySheet Globals => GlobalProperties.Sheet;

    public static GlobalKeyword[] globalKeywords => [.. GlobalKeywords.All.Select(k => new GlobalKeyword(k))];
    public static GlobalKeyword[] enabledGlobalKeywords => [.. GlobalKeywords.Enabled.Select(k => new GlobalKeyword(k))];

    public static void EnableKeyword(string keyword) => GlobalKeywords.Set(keyword, true);

    public static void EnableKeyword(in GlobalKeyword keyword) => GlobalKeywords.Set(keyword.name, true);

    public static void DisableKeyword(string keyword) => GlobalKeywords.Set(keyword, false);

    public static void DisableKeyword(in GlobalKeyword keyword) => GlobalKeywords.Set(keyword.name, false);

    public static void SetKeyword(in GlobalKeyword keyword, bool value) => GlobalKeywords.Set(keyword.name, value);

    public static bool IsKeywordEnabled(string keyword) => GlobalKeywords.IsEnabled(keyword);

    public static bool IsKeywordEnabled(in GlobalKeyword keyword) => GlobalKeywords.IsEnabled(keyword.name);

    public static void SetGlobalFloat(string name, float value) => Globals.SetFloat(ShaderNames.Id(name), value);

    public static void SetGlobalFloat(int nameID, float value) => Globals.SetFloat(nameID, value);

    public static void SetGlobalInt(string name, int value) => Globals.SetFloat(ShaderNames.Id(name), value);

    public static void SetGlobalInt(int nameID, int value) => Globals.SetFloat(nameID, value);

    public static void SetGlobalInteger(string name, int value) => Globals.SetInteger(ShaderNames.Id(name), value);

    public static void SetGlobalInteger(int nameID, int value) => Globals.SetInteger(nameID, value);

    public static void SetGlobalVector(string name, Vector4 value) => Globals.SetVector(ShaderNames.Id(name), value);

    public static void SetGlobalVector(int nameID, Vector4 value) => Globals.SetVector(nameID, value);

    public static void SetGlobalColor(string name, Color value) => Globals.SetColor(ShaderNames.Id(name), value);

    public static void SetGlobalColor(int nameID, Color value) => Globals.SetColor(nameID, value);

    public static void SetGlobalMatrix(string name, Matrix4x4 value) => Globals.SetMatrix(ShaderNames.Id(name), value);

    public static void SetGlobalMatrix(int nameID, Matrix4x4 value) => Globals.SetMatrix(nameID, value);

    public static void SetGlobalTexture(string name, Texture value) => SetGlobalTexture(ShaderNames.Id(name), value);

    public static void SetGlobalTexture(int nameID, Texture value) => Globals.SetTexture(nameID, new TextureSlot(value));

    public static void SetGlobalTexture(string name, RenderTexture value, RenderTextureSubElement element) =>
        SetGlobalTexture(ShaderNames.Id(name), value, element);

    public static void SetGlobalTexture(int nameID, RenderTexture value, RenderTextureSubElement element) =>
        Globals.SetTexture(nameID, new TextureSlot(value, 0, element));

    public static void SetGlobalBuffer(string name, ComputeBuffer value) => SetGlobalBuffer(ShaderNames.Id(name), value);

    public static void SetGlobalBuffer(int nameID, ComputeBuffer value) => Globals.SetBuffer(nameID, value?.Storage);

    public static void SetGlobalBuffer(string name, GraphicsBuffer value) => SetGlobalBuffer(ShaderNames.Id(name), value);

    public static void SetGlobalBuffer(int nameID, GraphicsBuffer value) => Globals.SetBuffer(nameID, value?.Storage);

    public static void SetGlobalConstantBuffer(string name, GraphicsBuffer value, int offset, int size) =>
        SetGlobalConstantBuffer(ShaderNames.Id(name), value, offset, size);

    public static void SetGlobalConstantBuffer(int nameID, GraphicsBuffer value, int offset, int size) =>
        Globals.SetConstantBuffer(nameID, new BufferSlot(value?.Storage, offset, size));

    public static void SetGlobalConstantBuffer(string name, ComputeBuffer value, int offset, int size) =>
        SetGlobalConstantBuffer(ShaderNames.Id(name), value, offset, size);

    public static void SetGlobalConstantBuffer(int nameID, ComputeBuffer value, int offset, int size) =>
        Globals.SetConstantBuffer(nameID, new BufferSlot(value?.Storage, offset, size));

    public static void SetGlobalFloatArray(string name, float[] values) => Globals.SetFloats(ShaderNames.Id(name), values);

    public static void SetGlobalFloatArray(int nameID, float[] values) => Globals.SetFloats(nameID, values);

    public static void SetGlobalFloatArray(string name, List<float> values) => SetGlobalFloatArray(ShaderNames.Id(name), values);

    public static void SetGlobalFloatArray(int nameID, List<float> values) => Globals.SetFloats(nameID, CollectionsMarshal.AsSpan(values));

    public static void SetGlobalVectorArray(string name, Vector4[] values) => Globals.SetVectors(ShaderNames.Id(name), values);

    public static void SetGlobalVectorArray(int nameID, Vector4[] values) => Globals.SetVectors(nameID, values);

    public static void SetGlobalVectorArray(string name, List<Vector4> values) => SetGlobalVectorArray(ShaderNames.Id(name), values);

    public static void SetGlobalVectorArray(int nameID, List<Vector4> values) => Globals.SetVectors(nameID, CollectionsMarshal.AsSpan(values));

    public static void SetGlobalMatrixArray(string name, Matrix4x4[] values) => Globals.SetMatrices(ShaderNames.Id(name), values);

    public static void SetGlobalMatrixArray(int nameID, Matrix4x4[] values) => Globals.SetMatrices(nameID, values);

    public static float GetGlobalFloat(string name) => Globals.GetFloat(ShaderNames.Id(name));

    public static float GetGlobalFloat(int nameID) => Globals.GetFloat(nameID);

    public static int GetGlobalInt(string name) => (int)Globals.GetFloat(ShaderNames.Id(name));

    public static int GetGlobalInt(int nameID) => (int)Globals.GetFloat(nameID);

    public static int GetGlobalInteger(string name) => Globals.GetInteger(ShaderNames.Id(name));

    public static int GetGlobalInteger(int nameID) => Globals.GetInteger(nameID);

    public static Vector4 GetGlobalVector(string name) => Globals.GetVector(ShaderNames.Id(name));

    public static Vector4 GetGlobalVector(int nameID) => Globals.GetVector(nameID);

    public static Color GetGlobalColor(string name) => Globals.GetVector(ShaderNames.Id(name));

    public static Color GetGlobalColor(int nameID) => Globals.GetVector(nameID);

    public static Matrix4x4 GetGlobalMatrix(string name) => Globals.GetMatrix(ShaderNames.Id(name));

    public static Matrix4x4 GetGlobalMatrix(int nameID) => Globals.GetMatrix(nameID);

    public static Texture? GetGlobalTexture(string name) => GetGlobalTexture(ShaderNames.Id(name));

    public static Texture? GetGlobalTexture(int nameID) => Globals.Textures.GetValueOrDefault(nameID).Texture;

    public static float[]? GetGlobalFloatArray(string name) => Globals.GetArray<float>(ShaderNames.Id(name), ShaderValueKind.FloatArray);

    public static Vector4[]? GetGlobalVectorArray(string name) => Globals.GetArray<Vector4>(ShaderNames.Id(name), ShaderValueKind.VectorArray);

    public static Matrix4x4[]? GetGlobalMatrixArray(string name) => Globals.GetArray<Matrix4x4>(ShaderNames.Id(name), ShaderValueKind.MatrixArray);
}
