namespace Headless.Checks.Form;

/// <summary>Assets of Unity's own packages that the project's settings refer to: GUIDs of com.unity.render-pipelines.universal 14.0.12.</summary>
internal static class UnityPackageAssets
{
    private static readonly Dictionary<string, string> paths = new()
    {
        ["247994e1f5a72c2419c26a37e9334c01"] = "Editor/UniversalProjectSettings.cs",
        ["bf2edee5c58d82540a51f03df9d42094"] = "Runtime/Data/UniversalRenderPipelineAsset.cs",
        ["41439944d30ece34e96484bdb6645b55"] = "Runtime/Data/PostProcessData.asset",
        ["60e1133243b97e347b653163a8c01b64"] = "Runtime/Data/XRSystemData.asset",
        ["de640fe3d0db1804a85f9fc8f5cadab6"] = "Runtime/UniversalRendererData.cs",
        ["2ec995e51a6e251468d2a3fd8a686257"] = "Runtime/UniversalRenderPipelineGlobalSettings.cs",
        ["c56b7e0d4c7cb484e959caeeedae9bbf"] = "Shaders/CameraMotionVectors.shader",
        ["cf852408f2e174538bcd9b7fda1c5ae7"] = "Shaders/Debug/DebugReplacement.shader",
        ["573620ae32aec764abd4d728906d2587"] = "Shaders/Debug/HDRDebugView.shader",
        ["7b3ede40266cd49a395def176e1bc486"] = "Shaders/ObjectMotionVectors.shader",
        ["6cda457ac28612740adb23da5d39ea92"] = "Shaders/PostProcessing/LensFlareDataDriven.shader",
        ["c17132b1f77d20942aa75f8429c0f8bc"] = "Shaders/Utils/Blit.shader",
        ["a89bee29cffa951418fc1e2da94d1959"] = "Shaders/Utils/BlitHDROverlay.shader",
        ["d6dae50ee9e1bfa4db75f19f99355220"] = "Shaders/Utils/CopyDepth.shader",
        ["93446b5c5339d4f00b85c159e1159b7c"] = "Shaders/Utils/CoreBlit.shader",
        ["d104b2fc1ca6445babb8e90b0758136b"] = "Shaders/Utils/CoreBlitColorAndDepth.shader",
        ["e6e9a19c3678ded42a3bc431ebef7dbd"] = "Shaders/Utils/FallbackError.shader",
        ["7f888aff2ac86494babad1c2c5daeee2"] = "Shaders/Utils/FallbackLoading.shader",
        ["5fd9a8feb75a4b5894c241777f519d4e"] = "Shaders/Utils/MaterialError.shader",
        ["04c410c9937594faa893a11dceb85f7e"] = "Shaders/Utils/Sampling.shader",
        ["e9155b26e1bc55942a41e518703fe304"] = "Shaders/Utils/StencilDeferred.shader",
        ["f9ee4ed84c1d10c49aabb9b210b0fc44"] = "Textures/BayerMatrix.png",
        ["e3d24661c1e055f45a7560c033dbb837"] = "Textures/BlueNoise64/L/LDR_LLL1_0.png",
    };

    public static bool Has(string guid) => paths.ContainsKey(guid);
}
